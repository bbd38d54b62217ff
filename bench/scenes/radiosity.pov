// SPDX-License-Identifier: AGPL-3.0-or-later
// A matte room around sheet and viewer, with things on a table. Its light comes through a window
// and by reflection from its walls.
#version 3.7;
global_settings { assumed_gamma 1
  radiosity { pretrace_start 0.08 pretrace_end 0.02 count 200 nearest_count 10 error_bound 0.4 recursion_limit 2
              low_error_factor 0.6 minimum_reuse 0.03 gray_threshold 0 brightness 1 adc_bailout 0.02 } }
#include "viewpoint.inc"
#default { finish { ambient 0 emission 0 diffuse 0.8 } }
background { rgb <2.5, 2.7, 3> }
light_source { <250, 170, -130> rgb <2.4, 2.2, 1.9> }
// walls, floor and ceiling, a window on the right
difference {
  box { <-85, -65, -155>, <85, 65, 65> }
  box { <-80, -60, -150>, <80, 60, 60> }
  box { <75, -30, -100>, <90, 55, 40> }
  pigment { rgb <0.85, 0.82, 0.75> }
}
box { <-80, -60, -150>, <-79.5, 60, 60> pigment { rgb <0.75, 0.3, 0.25> } }
box { <-16, -3, 59>, <-4, 12, 60> pigment { rgb <0.3, 0.45, 0.4> } }
box { <-25, -8, -25>, <25, -6.45, 50> pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.45, 0.35, 0.3> scale 4 } }
box { <-3, -6.5, -3>, <3, 3, 3> rotate y*25 translate <-5, 0, 25> pigment { rgb <0.8, 0.8, 0.75> } }
box { <-2.5, -6.5, -2.5>, <2.5, -2, 2.5> rotate y*-20 translate <4, 0, 6> pigment { rgb <0.35, 0.5, 0.75> } }
sphere { <4, -0.2, 6>, 1.8 pigment { rgb <0.85, 0.7, 0.3> } }
sphere { <-4.5, -4.7, -8>, 1.8 pigment { rgb <0.4, 0.65, 0.4> } }
cylinder { <8.5, -6.5, 30>, <8.5, 11, 30>, 1.2 pigment { rgb <0.8, 0.8, 0.8> } }
torus { 2, 0.6 translate <1, -5.8, -16> pigment { rgb <0.75, 0.45, 0.3> } }
