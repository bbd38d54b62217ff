// SPDX-License-Identifier: AGPL-3.0-or-later
// The thesis's text "abc" (figures 4-1 and 4-7), seen through lenticular lenses. It is Depth mm
// behind the sheet; a negative Depth is in front.
#version 3.7;
#include "integral.inc"
#ifndef (Depth) #declare Depth = -20; #end
global_settings { assumed_gamma 1.0 }
#declare Eye = 300;   // mm; one scene unit is a mm
camera {
  integral
  Integral_Sheet_1270()
  film { dpi 1200 units_per_mm 1 }
  location <0, 0, -Eye>
  look_at 0
  right x*image_width/image_height
}
background { rgb 1 }
#declare Font = "cyrvetic.ttf"; // comes with POV-Ray
#declare Text = text { ttf Font "abc", .01, 0 scale <1, 1, 1> }
#declare Middle = (min_extent(Text) + max_extent(Text))/2;
// Scaled so that it appears equally large to the eye at any depth.
object {
  Text
  translate -Middle
  scale <19, 19, 1>*<(Eye + Depth)/Eye, (Eye + Depth)/Eye, 1>
  translate Depth*z
  pigment { rgb 0 }
  finish { emission 0 ambient 0 diffuse 0 }
}
