// SPDX-License-Identifier: AGPL-3.0-or-later
// A mirroring floor and ball, and little else: a scene of which samples of other pixels tell least.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <0, 2, -12> look_at <0, 0.5, 0> angle 35 right x*image_width/image_height }
light_source { <-20, 30, -40> rgb 1 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.85, 0.75>] [0.6 rgb <0.25, 0.4, 0.75>] } } }
plane { y, -1 pigment { rgb <0.2, 0.15, 0.1> } finish { ambient 0.05 diffuse 0.2 reflection 0.8 } }
sphere { <-1.5, 0.5, 1>, 1.5 pigment { rgb 0.1 } finish { ambient 0 diffuse 0.1 reflection 0.85 specular 0.5 } }
box { <0.8, -1, -1>, <2.8, 1, 1> rotate y*20 pigment { checker rgb 1 rgb <0.7, 0.1, 0.1> scale 0.4 } }
cylinder { <3, -1, 6>, <3, 4, 6>, 0.5 pigment { gradient y color_map { [0.5 rgb <0, 0.5, 0>] [0.5 rgb 1] } scale 0.5 } }
