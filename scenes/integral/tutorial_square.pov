// SPDX-License-Identifier: AGPL-3.0-or-later
//
// tutorial_square.pov -- a sheet of square lenses: parallax in every direction; sheets by name
//
//   povray-integral +Itutorial_square.pov +W1200 +H900 +Otutorial_square.png
//   integral replay tutorial_square.png --eye 0,60,350 -o view.png          (an eye 60 mm above the middle)
//
// Under a lenticular sheet the scene changes only when the eye moves sideways. Square lenses in rows and columns also
// let you look over the ball and under the ring, but a lens's pixels are divided between both directions.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "integral.inc"                                        // names for sheets, films and sizes

camera {
  integral
  Integral_Sheet_1124()                                  // = lens_sheet { square pitch 1.124 thickness 3.23 ior 1.675 }
  Integral_Film_300()                                          // = film { dpi 300 }
  location <0, 0, -350>
  look_at <0, 0, 0>
  right x*image_width/image_height
  angle Integral_Angle(101.6, 350)                             // a print 101.6 mm wide, seen from 350 mm
}
// Again 1 unit is 1 mm, the sheet is the plane z = 0, and the viewer is at z = -350.

light_source { <-200, 300, -400> rgb 1 }
light_source { <300, 100, -300> rgb .35 shadowless }

#declare Shiny = finish { ambient .05 diffuse .8 specular .5 roughness .02 }

sphere { <-27, -15, -28>, 11  pigment { srgb <.90, .20, .15> }  finish { Shiny } }         // before the sheet
torus { 21, 5  rotate 90*x  rotate 60*y  pigment { srgb <.90, .70, .15> }  finish { Shiny } }   // across it
box { <-75, -60, 40>, <75, 60, 42>                                                         // behind it
  pigment { checker srgb <.88, .88, .92>, srgb <.32, .36, .55>  scale 15 } }
