// SPDX-License-Identifier: AGPL-3.0-or-later
// A disc of 44 mm (34 pitches and more) at depth Z millimetres behind (positive) or before
// (negative) the sheet. It fades towards its rim: a hard rim is cut into whole lenses, which moves
// its centroid by up to 3% of the parallax.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Eye_Distance) #declare Eye_Distance = 400; #end
#ifndef (Scale) #declare Scale = 1; #end
#declare Width = image_width * 25.4 / 300;
camera {
  integral
  #switch (Sheet)
    #case (1) lens_sheet { lenticular pitch 1.27 thickness 3.08 ior 1.6 } #break
    #case (2) lens_sheet { square pitch 1.124 thickness 3.23 ior 1.675 } #break
    #case (3) lens_sheet { hexagonal pitch 1.124 thickness 3.23 ior 1.675 } #break
    #case (4) lens_sheet { lenticular pitch 1.27 thickness 3.08 ior 1.6 slant 12 } #break
  #end
  film { dpi 300 }
  location -Eye_Distance*z
  direction Eye_Distance*z
  right Width*x
  up Width*image_height/image_width*y
}
disc { Z*z, z, 22*Scale pigment { spherical cubic_wave scale 22*Scale translate Z*z color_map { [0 rgb 0] [1 rgb 1] } } finish { ambient 1 diffuse 0 } }
