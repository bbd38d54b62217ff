// SPDX-License-Identifier: AGPL-3.0-or-later
// Nothing called so exists, so defined(), #ifdef and #ifndef say no; locals and #undef; include files ask the same way.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "colors.inc"
#declare Height = 0;
#ifdef (integral) #declare Height = 1; #end
#ifdef (lens_sheet) #declare Height = 2; #end
#ifndef (pitch) #local pitch = 0.5; #end
#ifndef (film) #declare film = Red; #else #declare film = Blue; #end
#if (defined(closest)) #declare Height = 3; #end
#declare auto = 1; #undef auto
#ifdef (auto) #declare Height = 4; #end
#switch (Height) #case (0) #declare lens_mapping = Green; #break #else #declare lens_mapping = Yellow; #end
camera { location <0, 1, -7> look_at 0 angle 40 right x * image_width / image_height }
light_source { <6, 8, -7> White }
sphere { Height * y, 1 pigment { film } }
sphere { <1.5, 0, 0>, pitch pigment { lens_mapping } }
plane { y, -1 pigment { checker White Black } }
