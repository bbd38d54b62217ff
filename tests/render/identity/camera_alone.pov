// SPDX-License-Identifier: AGPL-3.0-or-later
// A declared camera called integral keeps its meaning.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare integral = camera { location <0, 1, -7> look_at 0 angle 40 right x * 4 / 3 }
camera { integral }
light_source { <6, 8, -7> rgb 1 }
sphere { 0, 1 pigment { rgb <0.9, 0.3, 0.2> } }
plane { y, -1 pigment { checker rgb 0.9 rgb 0.4 } }
