// SPDX-License-Identifier: AGPL-3.0-or-later
// An animation whose declarations are called as the camera's words. Options: +KFF3
#version 3.7;
global_settings { assumed_gamma 1 }
#declare pitch = clock; #declare film = frame_number; #declare integral = final_frame;
camera { location <sin(pitch * 3), 1, -7> look_at 0 angle 40 right x * image_width / image_height }
light_source { <6, 8, -7> rgb 1 }
#declare slant = 0;
#while (slant < film) sphere { <slant - 1, slant / integral, 0>, 0.6 pigment { rgb <pitch, 0.5, 0.2> } } #declare slant = slant + 1; #end
plane { y, -1 pigment { checker rgb 0.9 rgb 0.4 } }
