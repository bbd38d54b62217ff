// SPDX-License-Identifier: AGPL-3.0-or-later
// Version 3.1, a camera called integral in the last of several cameras.
#version 3.1;
global_settings { assumed_gamma 1.0 }
#declare integral = camera { location <0, 1, -7> angle 40 right <1.3333, 0, 0> look_at <0, 0, 0> }
camera { location <9, 9, 9> look_at <0, 0, 0> }
camera { integral }
light_source { <6, 8, -7> color rgb 1 }
sphere { <0, 0, 0>, 1 pigment { color rgb <0.9, 0.3, 0.2> } }
plane { y, -1 pigment { checker color rgb 1 color rgb 0.3 } }
