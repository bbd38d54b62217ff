// SPDX-License-Identifier: AGPL-3.0-or-later
// The words as functions, pigment functions and parameters of functions; with isosurfaces and function patterns.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare pitch = function { sqrt(x*x + y*y + z*z) - 1 }
#declare slant = function (film, dpi) { film * 0.7 + dpi * 0.3 }
#declare lens_sheet = function (lenticular, square_, hexagonal) { pitch(lenticular, square_, hexagonal) + 0.1 * sin(10 * lenticular) }
#declare integral = function { pigment { gradient y color_map { [0 rgb 0.2] [1 rgb 0.9] } } }
#declare film_shift = function { pattern { wood scale 0.4 } }
#declare auto = function (x) { x * 0.5 }
#declare lens_mapping = function { spline { linear_spline 0, <0, 0, 0> 1, <1, 2, 3> } }
camera { location <0, 1, -5> look_at 0 angle 40 + auto(10) right x * 4 / 3 }
light_source { <4, 7, -6> rgb 1 }
isosurface { function { lens_sheet(x, y, z) } contained_by { sphere { 0, 1.4 } } max_gradient 4
  pigment { function { film_shift(x, y, z) } color_map { [0 rgb <1, 0.4, 0.1>] [1 rgb <0.2, 0.3, 0.9>] } } }
plane { y, -1.2 pigment { function { integral(x, slant(x, z), z).gray } } }
sphere { lens_mapping(0.5) * <1, 0.4, 0.2>, 0.3 pigment { rgb 0.9 } }
