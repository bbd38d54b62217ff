// SPDX-License-Identifier: AGPL-3.0-or-later
// The words as objects, textures, pigments, normals, finishes, interiors, materials, transforms, maps and lights.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare pitch = sphere { 0, 1 }
#declare film = box { -1, 1 }
#declare lenticular = union { object { pitch translate -1.5 * x } object { film scale 0.7 translate 1.5 * x } }
#declare lens_sheet = texture { pigment { rgb <0.9, 0.6, 0.2> } finish { phong 0.5 } }
#declare closest = pigment { checker rgb 0.9 rgb <0.2, 0.3, 0.7> scale 0.5 }
#declare accurate = normal { bumps 0.4 scale 0.2 }
#declare auto = finish { ambient 0.2 diffuse 0.6 reflection 0.2 }
#declare depth_range = interior { ior 1.4 fade_distance 2 fade_power 1 }
#declare beam_samples = material { texture { pigment { rgbf <0.9, 1, 0.9, 0.8> } finish { specular 0.6 } } interior { depth_range } }
#declare slant = transform { rotate 20 * z scale 0.9 }
#declare pixel_pitch = transform { translate y * 0.4 }
#declare dpi = color_map { [0 rgb <1, 0, 0>] [1 rgb <0, 0, 1>] }
#declare lens_model = light_source { <6, 8, -7> rgb 1 }
#declare sheet_distance = texture_map { [0 lens_sheet] [1 pigment { closest } ] }
#declare capture_aperture = sky_sphere { pigment { gradient y color_map { [0 rgb 0.8] [1 rgb <0.2, 0.4, 0.9>] } } }
#declare subpixels = fog { distance 60 rgb 0.7 }
camera { location <0, 1.5, -6> look_at <0, 0.2, 0> angle 50 right x * 4 / 3 }
light_source { lens_model }
sky_sphere { capture_aperture }
fog { subpixels }
object { lenticular texture { lens_sheet } transform { slant } transform pixel_pitch }
object { pitch scale 0.5 translate <0, -0.3, -1.5> material { beam_samples } }
object { film scale <3, 0.1, 3> translate -1.2 * y texture { pigment { closest } normal { accurate } finish { auto } } }
cylinder { <-3, -1, 2>, <-3, 2, 2>, 0.4 texture { gradient y texture_map { sheet_distance } } }
torus { 0.5, 0.15 translate <2.5, 1, 1> pigment { gradient x color_map { dpi } } }
