// SPDX-License-Identifier: AGPL-3.0-or-later
// Intersections, differences and merges of parts that have parts themselves, in every order: what is inside of what.
// Options: +A0.1 +R2
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <1, 6, -16> look_at <0, 0.5, 0> angle 55 right x*image_width/image_height }
light_source { <-20, 30, -25> rgb 1 }
plane { y, -2 pigment { checker rgb 0.9 rgb 0.4 } }

#declare Bumps = union { #for (I, 0, 11) sphere { <1.2, 0.6, 0>, 0.45 rotate 30*I*y } #end }
#declare Shell = difference { sphere { 0, 1.5 } sphere { 0, 1.3 } plane { -y, -0.4 inverse } }
#declare Glass = texture { pigment { rgbf <0.9, 0.95, 1, 0.8> } finish { specular 0.5 reflection 0.1 } }

// A compound first, last, within a compound, turned inside out.
intersection { object { Bumps inverse } cone { -y, 1.6, y, 0.9 } plane { y, 0.8 } translate <-6, 0, 0> pigment { rgb <1, 0.6, 0.3> } }
difference { box { -1.3, 1.3 } Bumps object { Shell translate y } translate <-2, 0, 0> pigment { rgb <0.4, 0.8, 0.5> } }
intersection { union { sphere { -0.6, 1.2 } sphere { 0.6, 1.2 } } merge { box { -1, 1 } cylinder { -1.5*x, 1.5*x, 0.6 } }
  translate <2, 0, 0> pigment { rgb <0.5, 0.5, 1> } finish { phong 0.6 } }
difference { merge { box { -1.2, 1.2 } sphere { 0, 1.5 } } intersection { sphere { <0.9, 0.9, -1>, 1 } object { Bumps inverse } }
  texture { Glass } interior { ior 1.4 } translate <6, 0, 0> }
// Clipped, bounded, and surfaces that share a plane.
difference { box { -1, 1 } union { box { <-0.5, -1, -1>, <0.5, 1, 0.2> } torus { 0.9, 0.2 } } clipped_by { object { Bumps scale 1.4 inverse } }
  translate <-4, 2.6, 3> pigment { rgb <0.9, 0.4, 0.7> } }
intersection { box { -1, 1 } Shell bounded_by { sphere { 0, 1.6 } } interior_texture { pigment { rgb 0.2 } } translate <0, 3, 3> pigment { rgb 0.8 } }
// A light with a body, and one without, among the parts.
intersection { sphere { 0, 1.3 } light_source { <0, 3, 0> rgb 0.3 looks_like { sphere { 0, 6 } } } light_source { <3, 5, 0> rgb 0.2 }
  object { Bumps inverse } translate <4, 3, 3> pigment { rgb <0.7, 0.9, 0.3> } }
