// SPDX-License-Identifier: AGPL-3.0-or-later
// Soft things in front of, across and behind a sheet at z = 0, 300 mm from the scene's eye, one unit
// a millimetre. Declare=Eye=1 and Eye_X, Eye_Y: the perspective picture of the sheet's rectangle of
// 60 x 40 mm as the scene's eye there sees it; else an integral camera for K = Declare=Parallax and
// Declare=Viewed mm.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifdef (Eye)
  camera { location <Eye_X, Eye_Y, -300> direction <-Eye_X, -Eye_Y, 300> right 60*x up 40*y }
#else
  camera {
    integral
    lens_sheet { square pitch 0.4 thickness 1.1 ior 1.56 }
    film { dpi 600 }
    location -300*z direction 300*z right 60*x up 40*y
    viewing_distance Viewed parallax Parallax
  }
#end
#declare Soft = finish { ambient 0 diffuse 0 emission 1 }
#macro Cloud(Middle, Size, Colour)
  disc { 0, z, Size pigment { spherical cubic_wave scale Size color_map { [0 rgbt <Colour.red, Colour.green, Colour.blue, 1>] [0.5 rgb Colour] [1 rgb Colour] } }
         finish { Soft } translate Middle }
#end
Cloud(<-12, 6, -18>, 13, rgb <0.9, 0.3, 0.2>)
Cloud(<14, -7, 0>, 12, rgb <0.2, 0.6, 0.3>)
Cloud(<3, 9, 14>, 15, rgb <0.8, 0.7, 0.2>)
plane { -z, -30 pigment { gradient x color_map { [0 rgb <0.2, 0.25, 0.5>] [0.5 rgb <0.6, 0.65, 0.6>] [1 rgb <0.2, 0.25, 0.5>] } scale 40 }
        finish { Soft } }
