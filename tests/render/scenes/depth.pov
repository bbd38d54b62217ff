// SPDX-License-Identifier: AGPL-3.0-or-later
// Things before, across and behind the sheet, whose colour tells their depth: green from 0 at -60
// mm to 1 at 100 mm; red where nothing is. In the world of straddle.pov: Scale scene units are a
// millimetre, turned by Turn.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Scale) #declare Scale = 1; #end
#ifndef (Turn) #declare Turn = 0; #end
#include "camera.inc"
background { red 1 }
#declare Depth = texture { pigment { gradient z color_map { [0 rgb 0] [1 green 1] } scale 160 translate -60*z } finish { ambient 1 diffuse 0 } }
#declare Things = union {
  plane { <0, 1, -0.05>, -5 clipped_by { box { <-40, -60, -55>, <40, 60, 95> } } }
  sphere { <-3, 1, -15>, 2.5 }
  torus { 4, 1 rotate 60*x translate <3, 0, 0> }
  difference { box { <-1, -4, 20>, <8, 5, 50> } sphere { <3, 1, 20>, 3 } }
  mesh { triangle { <-9, -3, 60>, <-1, -4, 90>, <-6, 7, 40> } }
  texture { Depth }
}
object { Things rotate <Turn * 0.5, Turn, Turn * 1.5> scale Scale translate Turn * Scale * <0.3, 0.1, -0.2> }
object { sphere { <2, 2, -30>, 2 } texture { Depth } no_image rotate <Turn * 0.5, Turn, Turn * 1.5> scale Scale translate Turn * Scale * <0.3, 0.1, -0.2> }
