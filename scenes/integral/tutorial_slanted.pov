// SPDX-License-Identifier: AGPL-3.0-or-later
//
// tutorial_slanted.pov -- a slanted lenticular sheet over an LCD panel
//
//   povray-integral +Itutorial_slanted.pov +W800 +H600 +Otutorial_slanted.png
//   integral replay tutorial_slanted.png --eye 60,0,450 -o view.png
//
// Vertical lenses over a panel with few pixels per lens (here 6) magnify the gaps between pixel columns, which are seen
// as dark bands. Turned by atan(1/6), each lens crosses one column every 6 rows. Then neighbouring rows show different
// directions: the sheet has less vertical resolution and finer steps between horizontal directions.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera {
  integral
  lens_sheet { lenticular pitch 1.27 thickness 3.08 ior 1.6 slant 9.4623 }   // degrees, anticlockwise to the viewer
  film { pixel_pitch 0.207 }                                   // mm: a panel's figure; a print would say dpi
  location <0, 0, -450>
  look_at <0, 0, 0>
  right x*image_width/image_height
  angle 2*degrees(atan2(165.6/2, 450))                         // 800 pixels of 0.207 mm = 165.6 mm
}
// Again 1 unit is 1 mm and the sheet is the plane z = 0. With 6 pixels a lens the depth that stays sharp is shallow:
// the objects here are larger and, in proportion, nearer to the sheet than in tutorial_lenticular.pov.

light_source { <-200, 300, -400> rgb 1 }
light_source { <300, 100, -300> rgb .35 shadowless }

#declare Shiny = finish { ambient .05 diffuse .8 specular .5 roughness .02 }

sphere { <-44, -24, -26>, 19  pigment { srgb <.20, .60, .65> }  finish { Shiny } }         // before the sheet
torus { 34, 9  rotate 90*x  rotate 65*y  pigment { srgb <.95, .55, .15> }  finish { Shiny } }   // across it
box { <-120, -95, 34>, <120, 95, 36>                                                       // behind it
  pigment { checker srgb <.92, .90, .85>, srgb <.45, .30, .40>  scale 27 } }
