// SPDX-License-Identifier: AGPL-3.0-or-later
// Surfaces whose shading may be shared, and surfaces whose may not: Kind says which. About a sheet
// at z = 0, millimetres. The camera is in camera.inc. Light: 0 one point, 1 an area, 2 five points,
// 3 one point without shadows.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5
  #ifdef (Radiosity) radiosity { count 60 error_bound 0.7 recursion_limit 1 pretrace_start 0.08 pretrace_end 0.04 }
    #end }
#ifndef (Light) #declare Light = 1; #end
#ifndef (Kind) #declare Kind = 1; #end
#ifndef (Shine) #declare Shine = 1; #end // of Glossy
#declare Own = 1; #declare Matte = 2; #declare Glossy = 3; #declare Csg = 4; #declare Cut = 5; #declare Lists = 6;
  #declare Uv = 7;
#declare Inside = 8; #declare Meshes = 9; #declare Layers = 10;
#include "camera.inc"
#if (Light = 1)
  light_source { <12, 19, -31>, rgb 0.6 area_light x * 4, y * 4, 5, 5 }
#else
  #for (K, 1, (Light = 2 ? 5 : 1))
    light_source { <7 * K - 20, 19, -31>, rgb (Light = 2 ? 0.15 : 0.6) #if (Light = 3) shadowless #end }
  #end
#end
#if (Kind != Own) background { rgb <0.2, 0.3, 0.5> } #end
#declare Plain = finish { ambient 0.15 diffuse 0.7 };
#declare Squares = texture { pigment { checker rgb <0.9, 0.8, 0.3> rgb <0.2, 0.3, 0.7> scale 1.37 translate 0.21 }
  finish { Plain } }
#declare Slopes = texture { pigment { gradient x color_map { [0 rgb <0.1, 0.6, 0.2>] [1 rgb <0.9, 0.5, 0.4>] } scale
  2.9 } finish { Plain } }
#declare Wall = plane { -z, -30 texture { Squares scale 4 } };

#switch (Kind)
#case (Own)
  plane { -z, -30 pigment { checker rgb 0.9 rgb <0.3, 0.2, 0.5> scale 4 } finish { Plain reflection 0.2 } }
  sphere { <-4, 2, 3>, 1.9 pigment { rgb 0.2 } finish { Plain reflection { 0.2, 0.8 } } }
  sphere { <0, 2, -3>, 1.5 pigment { rgbf <0.9, 1, 1, 0.9> } finish { Plain } interior { ior 1.4 } }
  sphere { <4, 2, 1>, 1.9 pigment { rgbt <0.9, 0.4, 0.2, 0.4> } finish { Plain } }
  sphere { <-4, -2, 2>, 1.9 pigment { rgb <0.4, 0.8, 0.5> } finish { Plain crand 0.3 } }
  sphere { <0, -2, 2>, 1.9 pigment { aoi color_map { [0 rgb <1, 0.3, 0>] [0.5 rgb <0, 0.4, 1>] [1 rgb <1, 1, 0>] } }
    finish { Plain } }
  sphere { <4, -2, 2>, 1.9 pigment { rgb 0.6 } finish { Plain irid { 0.5 thickness 0.6 turbulence 0.3 } } }
#break
#case (Matte)
  object { Wall }
  sphere { <-3, 1, 2>, 2.4 texture { Squares } }
  torus { 2, 0.7 rotate x * 60 translate <3, -1, -3> texture { Slopes } normal { bumps 0.3 scale 0.7 } }
  plane { y, -5 texture { Slopes } }
#break
#case (Glossy)
  object { Wall }
  sphere { <-3, 1, 2>, 2.4 texture { Squares finish { Plain specular 0.7 * Shine roughness 0.03 } } }
  sphere { <3, -1, -3>, 1.9 texture { Slopes finish { Plain phong 0.8 * Shine phong_size 30 } } }
#break
#case (Csg)
  object { Wall }
  difference { box { <-5, -2, 0>, <-1, 2, 5> texture { Squares } } sphere { <-3, 0, 0>, 1.7 texture { Slopes } } rotate
    y * 20 }
  merge { sphere { <2, 1, 1>, 1.5 } sphere { <3.5, 0, 1>, 1.5 } texture { Slopes } }
  intersection { sphere { <2, -2, -2>, 1.6 } box { <1, -3, -4>, <4, -1, -1.5> } texture { Squares } }
  difference { sphere { <-2, -3, -3>, 1.5 } box { <-4, -3.5, -6>, <0, -2.5, 0> } cutaway_textures texture { Slopes } }
#break
#case (Cut)
  object { Wall }
  sphere { <-2.5, 0, 2>, 2.6 clipped_by { plane { -z, -1.5 } } texture { Squares } interior_texture { Slopes } }
  sphere { <2.5, 0, -1>, 2.2 clipped_by { plane { -z, 1.7 } } texture { Slopes } }
  union { cone { <2, -4, 0>, 1, <2, -2, 1>, 0 } disc { <-3, -3, -2>, <0.3, 0.5, -1>, 1.6, 0.5 } bounded_by { box { <-9,
    -9, -9>, 9 } } texture { Squares } }
#break
#case (Lists)
  object { Wall }
  blob { threshold 0.5 sphere { <-2.5, 0, 1>, 2.6, 1 texture { Squares } } sphere { <-0.5, 1, 0>, 2.2, 1 texture {
    Slopes } } }
  sphere { <3, 0, 0>, 2.2 texture { gradient y texture_map { [0.3 Squares] [0.7 Slopes] } scale 3 } }
  sphere { <0, -3, -2>, 1.3 texture { checker texture { Squares } texture { Slopes } scale 0.9 } }
#break
#case (Uv)
  object { Wall }
  sphere { 0, 2.3 texture { uv_mapping pigment { checker rgb 0.9 rgb <0.7, 0.1, 0.2> scale 0.1 } finish { Plain } }
    rotate <20, 30, 0> translate <-2.8, 0, 2> }
  bicubic_patch { type 1 flatness 0.01 u_steps 3 v_steps 3 <0, -3, 0>, <2, -3, -2>, <3, -3, 0>, <5, -3, 0>, <0, -1, 0>,
    <2, -1, -3>,
    <3, -1, 0>, <5, -1, 0>, <0, 1, 0>, <2, 1, 0>, <3, 1, -3>, <5, 1, 0>, <0, 3, 0>, <2, 3, 0>, <3, 3, 0>, <5, 3, 0>
    texture { uv_mapping pigment { checker rgb 0.9 rgb <0.1, 0.5, 0.2> scale 0.13 } finish { Plain } } }
#break
#case (Inside) // the camera is in them
  sphere { 0, 60 inverse texture { Squares scale 9 } }
  box { <-50, -9, -50>, <50, 30, 45> texture { Slopes scale 4 } interior_texture { Squares scale 5 } }
  sphere { <1, 0, 4>, 2.5 texture { Slopes } }
#break
#case (Meshes)
  object { Wall }
  mesh {
    #for (K, 0, 7)
      #local A = K * 45; #local B = A + 45;
      triangle { vrotate(x * 3, z * A) + z * 2, vrotate(x * 3, z * B) + z * 2, <0, 0, -3> texture { #if (mod(K, 2))
        Squares #else Slopes #end } }
    #end
    translate x * -2
  }
  mesh2 { vertex_vectors { 4, <1, -3, 0>, <5, -3, 1>, <1, 2, 3>, <5, 2, -1> } normal_vectors { 4, <-1, 0, -3>, <1, 0,
    -3>, <0, 1, -3>, <1, 1, -3> }
    texture_list { 2, texture { Squares } texture { Slopes } } face_indices { 2, <0, 1, 2>, 0, 1, 0, <1, 2, 3>, 1, 1, 0
      } }
#break
#case (Layers)
  object { Wall }
  sphere { <-2.5, 0, 2>, 2.4 texture { Squares } texture { pigment { gradient x color_map { [0 rgbt 1] [0.5 rgb <0.2,
    0.7, 0.3>] } scale 1.7 } finish { Plain } } }
  sphere { <2.5, 0, -1>, 2.1 texture { pigment { gradient y color_map { [0.5 rgbt 1] [0.5 rgb <0.9, 0.4, 0.2>] } scale
    1.1 } finish { Plain } } }
#break
#end
