// SPDX-License-Identifier: AGPL-3.0-or-later
// Large smooth bodies, gradients and soft shadows. Except for a few outlines, the picture has low
// spatial frequencies only.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "viewpoint.inc"
light_source { <-120, 200, -250> rgb 0.9 area_light 80*x, 80*y, 4, 4 adaptive 1 circular orient }
#default { finish { ambient 0.25 diffuse 0.75 } }
plane { -z, -60 pigment { bozo color_map { [0 rgb <0.75, 0.8, 0.9>] [1 rgb <0.45, 0.55, 0.75>] } scale 30 } }
plane { y, -6 pigment { bozo color_map { [0 rgb <0.85, 0.75, 0.6>] [1 rgb <0.65, 0.5, 0.4>] } scale 25 } }
sphere { <-4, 0, 15>, 6 pigment { gradient y color_map { [0 rgb <0.9, 0.5, 0.3>] [1 rgb <0.8, 0.7, 0.3>] } scale 14 translate -7*y } }
sphere { <4, -2.8, -10>, 3.2 pigment { rgb <0.4, 0.65, 0.45> } }
torus { 5, 1.5 rotate x*70 translate <7, 3, 35> pigment { rgb <0.7, 0.5, 0.7> } }
cone { <-5, -6, -25>, 2, <-5, 0.5, -25>, 0.3 pigment { rgb <0.55, 0.6, 0.85> } }
