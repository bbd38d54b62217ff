// SPDX-License-Identifier: AGPL-3.0-or-later
// A plain scene: matte bodies of a few textures, three point lights, hard shadows.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "viewpoint.inc"
#default { finish { ambient 0.15 diffuse 0.75 } }
light_source { <-200, 300, -400> rgb 0.7 }
light_source { <250, 150, -200> rgb <0.3, 0.35, 0.4> }
light_source { <-50, 80, -350> rgb <0.25, 0.2, 0.15> }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.85, 0.85, 0.8>] [0.5 rgb <0.35, 0.5, 0.8>] } } }
plane { y, Floor pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.35, 0.45, 0.4> scale 6 } }
plane { -z, -90 pigment { bozo turbulence 0.5 scale 14 color_map { [0 rgb <0.7, 0.65, 0.6>] [1 rgb <0.5, 0.55, 0.65>] } } }
sphere { <-5, -2, 12>, 4 pigment { marble turbulence 0.6 scale 3 color_map { [0 rgb 0.9] [1 rgb <0.35, 0.3, 0.45>] } } }
box { <-2, -6, -2>, <2, -1.5, 2> rotate y*35 translate <4.5, 0, -8> pigment { wood turbulence 0.1 rotate y*85 scale 1.2
      color_map { [0 rgb <0.7, 0.45, 0.25>] [1 rgb <0.45, 0.25, 0.12>] } } }
cone { <7, -6, 30>, 4, <7, 7, 30>, 0 pigment { rgb <0.8, 0.35, 0.25> } }
torus { 2.2, 0.8 rotate x*60 translate <0.5, 2.5, 5> pigment { rgb <0.85, 0.7, 0.25> } }
cylinder { <-9, -6, 40>, <-9, 9, 40>, 1.8 pigment { gradient y color_map { [0.5 rgb 0.85] [0.5 rgb <0.3, 0.4, 0.65>] } scale 3 } }
sphere { <-5, -5, -20>, 1.2 pigment { rgb <0.35, 0.6, 0.4> } }
superellipsoid { <0.25, 0.25> scale 1.5 rotate <25, 30, 10> translate <0, -4.3, -14> pigment { rgb <0.55, 0.45, 0.75> } }
