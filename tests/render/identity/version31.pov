// SPDX-License-Identifier: AGPL-3.0-or-later
// An old scene: version 3.1's camera syntax, where the order of the words matters, and the words as identifiers.
#version 3.1;
#declare integral = <0, 1, -7>
#declare pitch = 35
#declare lens_sheet = <1.3333, 0, 0>
#declare film = texture { pigment { color red 0.9 green 0.3 blue 0.2 } finish { phong 0.6 } }
#declare closest = camera { location integral direction <0, 0, 1.5> up <0, 1, 0> right lens_sheet }
camera { closest look_at <0, 0, 0> rotate <0, pitch, 0> translate <0.2, 0, 0> }
light_source { <6, 8, -7> color rgb 1 }
sphere { <0, 0, 0>, 1 texture { film } }
plane { y, -1 pigment { checker color red 1 color blue 1 } }
#declare lens_mapping = 3
#while (lens_mapping > 0)
  box { -0.3, 0.3 translate <lens_mapping - 2, 1.2, lens_mapping> texture { film } }
  #declare lens_mapping = lens_mapping - 1
#end
