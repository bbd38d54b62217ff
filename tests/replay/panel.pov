// SPDX-License-Identifier: AGPL-3.0-or-later
// Depth in front of, across and behind a panel at z = 0, one unit a millimetre. Declare=Eye=1 and
// Eye_X, Eye_Y: the perspective picture of the panel's rectangle, Width mm wide, as an eye there
// sees it; else an integral camera of Panel = 1, 2 or 3.
#version 3.7;
global_settings { assumed_gamma 1 }

#declare Distance = 502;
#ifdef (Eye)
  camera {
    location <Eye_X, Eye_Y, -Distance>
    direction <-Eye_X, -Eye_Y, Distance>
    right Width*x
    up Width*image_height/image_width*y
  }
#else
  #include "integral.inc"
  camera {
    integral
    #switch (Panel)
      #case (1) Integral_Panel_Looking_Glass_Portrait() #break
      #case (2) lens_sheet { lenticular pitch 0.4878 thickness 1.0446 ior 1.49 slant -8.13 offset <0.083, 0> }
                film { pixel_pitch 25.4/324 subpixels vrgb } #break
      #case (3) Integral_Panel_Looking_Glass_16_Landscape() #break
    #end
    location -Distance*z
    direction Distance*z
    right Width*x
    up Width*image_height/image_width*y
  }
#end

light_source { <-200, 300, -400> rgb 1 }
sphere { <-8, 2, -8>, 7 pigment { rgb <0.9, 0.3, 0.2> } finish { ambient 0.2 diffuse 0.8 } }
cylinder { <9, -30, -6>, <9, 30, 7>, 3 pigment { rgb <0.2, 0.7, 0.3> } finish { ambient 0.2 diffuse 0.8 } }
plane { -z, -14 pigment { gradient x color_map { [0 rgb <0.1, 0.2, 0.6>] [0.5 rgb <0.9, 0.9, 0.6>] [1 rgb <0.1, 0.2, 0.6>] } scale 24 }
        finish { ambient 0.6 diffuse 0.4 } }
