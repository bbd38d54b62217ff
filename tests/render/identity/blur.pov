// SPDX-License-Identifier: AGPL-3.0-or-later
// The words inside other cameras: as values of focal blur and of a camera's normal.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare integral = <0, 1, -7>; #declare film = <0, 0, 0>; #declare pitch = 0.3; #declare beam_samples = 7;
#declare lens_sheet = normal { bumps 0.05 scale 0.5 } #declare closest = 0.9; #declare accurate = 0.01;
#declare slant = <0, 1, 0>; #declare pixel_pitch = <1.33, 0, 0>; #declare sheet_distance = <0, 0, 1.8>;
camera {
  location integral sky slant direction sheet_distance right pixel_pitch up slant
  look_at film
  aperture pitch blur_samples beam_samples focal_point film confidence closest variance accurate
  normal { lens_sheet }
}
light_source { <6, 8, -7> rgb 1 }
sphere { film, 1 pigment { rgb <0.9, 0.3, 0.2> } }
plane { slant, -1 pigment { checker rgb 0.9 rgb 0.4 } }
