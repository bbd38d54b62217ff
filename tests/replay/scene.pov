// SPDX-License-Identifier: AGPL-3.0-or-later
// Depth in front of, across and behind a sheet at z = 0, one unit a millimetre. Declare=Eye=1 and
// Eye_X, Eye_Y: the perspective picture of the sheet's rectangle as an eye there sees it; else an
// integral camera, Sheet = 1, 2, 3 or 4.
#version 3.7;
global_settings { assumed_gamma 1 }

#declare Distance = 350;
#declare Film_Width = image_width * 25.4 / 300;
#ifdef (Eye)
  camera {
    location <Eye_X, Eye_Y, -Distance>
    direction <-Eye_X, -Eye_Y, Distance>
    right Sheet_Width*x
    up Sheet_Width*image_height/image_width*y
  }
#else
  camera {
    integral
    #switch (Sheet)
      #case (1) lens_sheet { lenticular pitch 1.27 thickness 3.08 ior 1.6 } #break
      #case (2) lens_sheet { square pitch 1.124 thickness 3.23 ior 1.675 } #break
      #case (3) lens_sheet { hexagonal pitch 1.124 thickness 3.23 ior 1.675 } #break
      #case (4) lens_sheet { lenticular pitch 1.27 thickness 3.08 ior 1.6 slant 12 } #break
    #end
    film { dpi 300 }
    location -Distance*z
    direction Distance*z
    right Film_Width*x
    up Film_Width*image_height/image_width*y
  }
#end

light_source { <-200, 300, -400> rgb 1 }
sphere { <-10, 3, -15>, 8 pigment { rgb <0.9, 0.3, 0.2> } finish { ambient 0.2 diffuse 0.8 } }
cylinder { <12, -30, -10>, <12, 30, 12>, 4 pigment { rgb <0.2, 0.7, 0.3> } finish { ambient 0.2 diffuse 0.8 } }
plane { -z, -40 pigment { gradient x color_map { [0 rgb <0.1, 0.2, 0.6>] [0.5 rgb <0.9, 0.9, 0.6>] [1 rgb <0.1, 0.2, 0.6>] } scale 60 }
        finish { ambient 0.6 diffuse 0.4 } }
