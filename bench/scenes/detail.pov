// SPDX-License-Identifier: AGPL-3.0-or-later
// Matte things with fine detail, from 40 mm in front of the sheet to 60 mm behind it. They have
// edges everywhere, but no reflection, transparency or soft shadows.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "viewpoint.inc"
light_source { <-200, 300, -400> rgb 1 }
#default { finish { ambient 0.15 diffuse 0.85 } }

// the wall behind: bricks of 4 x 1.5 mm
plane { -z, -60 pigment { brick rgb 0.9, rgb <0.7, 0.25, 0.15> brick_size <4, 1.5, 4> mortar 0.35 } }
// a floor of 2 mm squares that runs through the sheet, and a board with stripes of 1 mm
plane { y, Floor pigment { checker rgb <0.95, 0.9, 0.8> rgb <0.1, 0.25, 0.45> scale 2 } }
box { <-4, -0.3, -50>, <4, 0.3, 50> rotate z*35 rotate x*-4 translate <5.5, 1, 12>
      pigment { gradient z color_map { [0.5 rgb <0.95, 0.75, 0.1>] [0.5 rgb 0.05] } scale 2 } }
// pegs, 1 mm thick, at every depth
#declare R = seed(7);
#for (I, 0, 27)
  #declare Z = -40 + 100*I/27;
  cylinder { <0, -6, 0>, <0, -6 + 2 + 7*rand(R), 0>, 0.5 translate <(rand(R) - 0.5)*(20 + Z/6), 0, Z>
             pigment { hexagon rgb <rand(R), rand(R), 0.3> rgb 1 rgb <0.1, rand(R), rand(R)> scale 0.5 } }
#end
// lettering in the sheet
text { internal 1 "Lippmann" 0.5, 0 scale 3.6 translate <-9, 2.5, 0> pigment { rgb <0.05, 0.05, 0.3> } }
text { internal 1 "integral" 0.5, 0 scale 2.2 translate <-6.5, -0.5, -15> pigment { rgb <0.7, 0, 0.1> } }
