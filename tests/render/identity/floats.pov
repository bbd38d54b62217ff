// SPDX-License-Identifier: AGPL-3.0-or-later
// Every word of the integral camera as a float, used everywhere a float can stand, the camera included.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare integral = 1; #declare lens_sheet = 2; #declare lenticular = 0.5; #declare hexagonal = 0.3;
#declare pitch = 3; #declare slant = 25; #declare film_shift = 0.25; #declare film = 4; #declare dpi = 300;
#declare pixel_pitch = 0.207; #declare units_per_mm = 0.1; #declare subpixels = 3; #declare sheet_distance = 8;
#declare capture_aperture = 0.6; #declare aperture_shape = 1.5; #declare rectangle = 0.7; #declare ellipse = 0.4;
#declare lens_model = 2.5; #declare pinhole = 0.2; #declare extended_pinhole = 0.8; #declare hybrid = 0.1; #declare full = 0.9;
#declare lens_mapping = 5; #declare closest = 0.15; #declare accurate = 0.35; #declare auto = 0.55; #declare exhaustive = 0.75;
#declare beam_samples = 6; #declare depth_range = 7; #declare pseudoscopic = 0.05; #declare none = 0; #declare bgr = 0.45;
background { rgb <closest, accurate, auto> }
camera {
  perspective
  location <film_shift, lens_sheet, -sheet_distance> right x * film / pitch up y angle slant * lens_sheet
  look_at <none, lenticular, none>
}
light_source { <film, depth_range, -beam_samples> rgb integral }
sphere { <none, lenticular, none>, integral pigment { rgb <full, extended_pinhole, pinhole> }
  finish { ambient hybrid + pseudoscopic diffuse rectangle phong ellipse phong_size dpi / units_per_mm / 100 } }
box { <-lens_model, -aperture_shape, integral>, <lens_model, -lenticular - hexagonal, lens_mapping>
  pigment { checker rgb exhaustive rgb bgr scale capture_aperture } rotate y * slant * pixel_pitch }
cylinder { <-subpixels, none, 2>, <subpixels, 1, 2>, film_shift pigment { gradient x color_map { [none rgb auto] [integral rgb closest] } } }
