// SPDX-License-Identifier: AGPL-3.0-or-later
// The words as values of a camera of another type.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare integral = <0.3, 1, -4>; #declare film = <0, 0, 0>; #declare pitch = 110; #declare lens_sheet = <1.3333, 0, 0>;
#declare slant = 15; #declare pixel_pitch = <0.2, 0, 0>; #declare dpi = <1.1, 1.1, 1.1>; #declare lenticular = transform { rotate x * 2 }
camera {
  spherical
  angle pitch location integral right lens_sheet look_at film
  rotate z * slant translate pixel_pitch scale dpi transform lenticular
}
light_source { <6, 8, -7> rgb 1 }
sphere { film, 1 pigment { rgb <0.9, 0.3, 0.2> } }
plane { y, -1 pigment { checker rgb 0.9 rgb 0.4 } }
