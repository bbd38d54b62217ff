// SPDX-License-Identifier: AGPL-3.0-or-later
// The words as vectors, colours, strings, arrays and splines.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare integral = <0, 2, -9>;            // vectors
#declare film = <0, 0.5, 0>;
#declare lens_sheet = <16, 12> / 12;
#declare depth_range = <0.1, 0.2, 0.9>;
#declare capture_aperture = x * 1.3333;
#declare lenticular = color rgb <1, 0.5, 0.2>;  // colours
#declare pitch = color rgbf <0.3, 0.9, 0.5, 0.4>;
#declare closest = rgbt <0.2, 0.3, 0.8, 0.1>;
#declare dpi = "300";                      // strings
#declare lens_mapping = concat("auto", dpi, "x");
#declare aperture_shape = "lens_mapping closest";
#declare slant = array[3] { 10, 20, 30 }   // arrays
#declare pixel_pitch = array[2] { <1, 0, 0>, <0, 1, 1> }
#declare subpixels = array[2][2] { { 0.1, 0.2 }, { 0.3, 0.4 } }
#declare sheet_distance = spline { natural_spline 0, <-3, 0, 0> 0.5, <0, 1, 2> 1, <3, 0, 0> }
#declare units_per_mm = spline { cubic_spline -1, 0 0, 1 1, 3 2, 4 }
camera { location integral right capture_aperture up y * lens_sheet.v angle slant[2] + val(dpi) / 100 look_at film }
light_source { <3, 9, -8> rgb 1 }
#declare Index = 0;
#while (Index < 8)
  sphere { sheet_distance(Index / 7), 0.2 + subpixels[mod(Index, 2)][1] / 2
    pigment { #if (mod(Index, 3) = 0) color lenticular #else #if (mod(Index, 3) = 1) color pitch #else color closest #end #end }
    translate pixel_pitch[mod(Index, 2)] * units_per_mm(0.5).x * 0.1 }
  #declare Index = Index + 1;
#end
plane { y, -1 pigment { checker color depth_range color lenticular } }
text { ttf "timrom.ttf" lens_mapping 0.2, 0 pigment { color pitch } translate <-2, -0.7, -2> }
#if (strlen(aperture_shape) = 20) sphere { <2, 2, 0>, 0.5 pigment { color pitch } } #end
