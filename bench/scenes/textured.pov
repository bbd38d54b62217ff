// SPDX-License-Identifier: AGPL-3.0-or-later
// Stone, wood and layered textures with highlights, lit by two area lights. Shading takes much
// time; shadows are smooth.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
#include "viewpoint.inc"
light_source { <-150, 220, -260> rgb <0.8, 0.75, 0.65> area_light 60*x, 60*y, 5, 5 adaptive 1 circular orient }
light_source { <180, 120, -200> rgb <0.3, 0.35, 0.45> area_light 40*x, 40*y, 4, 4 adaptive 1 }
#declare Granite = texture {
  pigment { granite turbulence 0.3 scale 5
    color_map { [0 rgb <0.35, 0.3, 0.3>] [0.4 rgb <0.75, 0.65, 0.6>] [0.7 rgb <0.9, 0.85, 0.8>] [1 rgb <0.3, 0.3, 0.35>] } }
  finish { ambient 0.12 diffuse 0.75 specular 0.35 roughness 0.02 } }
#declare Marble = texture {
  pigment { marble turbulence 0.7 octaves 5 rotate z*40 scale 4
    color_map { [0 rgb <0.95, 0.93, 0.9>] [0.6 rgb <0.75, 0.72, 0.7>] [0.85 rgb <0.3, 0.32, 0.35>] [1 rgb <0.9, 0.88, 0.85>] } }
  finish { ambient 0.12 diffuse 0.75 specular 0.5 roughness 0.01 } }
#declare Wood =
  texture { pigment { wood turbulence 0.06 octaves 3 rotate y*80 rotate x*3 scale 1.6
      color_map { [0 rgb <0.75, 0.5, 0.28>] [0.7 rgb <0.5, 0.28, 0.13>] [1 rgb <0.72, 0.47, 0.25>] } }
    finish { ambient 0.12 diffuse 0.75 specular 0.2 roughness 0.05 } }
  texture { pigment { wood turbulence 0.3 rotate y*80 scale <0.4, 0.4, 6>
      color_map { [0 rgbt 1] [0.6 rgbt <0.3, 0.15, 0.05, 0.6>] [1 rgbt 1] } }
    finish { ambient 0.1 diffuse 0.6 } }
#declare Rust =
  texture { pigment { bozo turbulence 0.6 scale 3 color_map { [0 rgb <0.35, 0.5, 0.45>] [1 rgb <0.5, 0.6, 0.5>] } }
    finish { ambient 0.12 diffuse 0.7 specular 0.4 roughness 0.03 } }
  texture { pigment { bozo turbulence 0.8 octaves 6 scale 1.5
      color_map { [0 rgbt 1] [0.45 rgbt 1] [0.6 rgbt <0.55, 0.25, 0.1, 0.1>] [1 rgbt <0.4, 0.15, 0.05, 0>] } }
    finish { ambient 0.1 diffuse 0.6 } }
plane { y, -6 texture { Wood } }
plane { -z, -70 texture { Granite scale 2 } }
cylinder { <-7, -6, 25>, <-7, 12, 25>, 2.2 texture { Marble } }
cylinder { <8, -6, 40>, <8, 14, 40>, 2.6 texture { Marble translate 5 } }
sphere { <-1.5, -2.4, 8>, 3.6 texture { Granite } }
box { <-1.6, -1.6, -1.6>, <1.6, 1.6, 1.6> rotate y*30 translate <5, -4.4, -6> texture { Rust } }
superellipsoid { <0.3, 0.3> scale 2 rotate <20, 40, 0> translate <-6, -3.7, -12> texture { Wood } }
torus { 2.4, 0.7 rotate x*80 translate <3, 2.5, 18> texture { Rust } }
sphere { <2.5, -5, -22>, 1 texture { Marble } }
