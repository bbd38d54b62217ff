// SPDX-License-Identifier: AGPL-3.0-or-later
// A white disc of 13 mm (10 pitches and more) at depth Z millimetres behind (positive) or before (negative) the sheet.
// The film is finer than a print's, and its pixels fall differently behind each lens: at 300 dpi a pixel is seen from
// 13 mm of eye positions (4-5), alike for every lens of 1.27 mm, and parallax moves in steps of that.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Width = image_width * 25.4 / 1337;
camera {
  integral
  #switch (Sheet)
    #case (1) lens_sheet { lenticular pitch 1.27 thickness 3.08 ior 1.6 } #break
    #case (2) lens_sheet { square pitch 1.124 thickness 3.23 ior 1.675 } #break
    #case (3) lens_sheet { hexagonal pitch 1.124 thickness 3.23 ior 1.675 } #break
    #case (4) lens_sheet { lenticular pitch 1.27 thickness 3.08 ior 1.6 slant 12 } #break
  #end
  film { dpi 1337 }
  location -400*z
  direction 400*z
  right Width*x
  up Width*image_height/image_width*y
}
disc { Z*z, z, 6.5 pigment { rgb 1 } finish { ambient 1 diffuse 0 } }
