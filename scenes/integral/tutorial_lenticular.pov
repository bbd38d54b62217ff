// SPDX-License-Identifier: AGPL-3.0-or-later
//
// tutorial_lenticular.pov -- the smallest integral picture: a lenticular sheet over a 300 dpi print
//
//   povray-integral +Itutorial_lenticular.pov +W1200 +H900 +Otutorial_lenticular.png
//   integral replay tutorial_lenticular.png --eye 60,0,350 -o view.png      (an eye 60 mm to the right)
//
// The frame looks like stripes. Printed 1200 pixels = 101.6 mm wide and laid under the sheet, it shows a scene in
// depth: the ball is in front of the paper, the ring is half in front of it and half behind it, the board is behind.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera {
  integral                                                     // what follows differs from a perspective camera:
  lens_sheet { lenticular pitch 1.27 thickness 3.08 ior 1.6 }  // upright cylinder lenses, 1.27 mm apart (mm throughout)
  film { dpi 300 }                                             // the print: 25.4/300 mm a pixel, so 15 pixels a lens
  location <0, 0, -350>                                        // where the viewer's eye will be
  look_at <0, 0, 0>                                            // the sheet stands here, square to the line of sight
  right x*image_width/image_height
  angle 2*degrees(atan2(101.6/2, 350))                         // the window at the sheet: 101.6 units wide
}
// 101.6 units = 101.6 mm, so here 1 unit is 1 mm. Objects at z < 0 are in front of the sheet, at z > 0 behind it.
// Keep important objects within about 40 mm of the sheet. Farther away they blur, more so with fewer pixels per lens.

light_source { <-200, 300, -400> rgb 1 }
light_source { <300, 100, -300> rgb .35 shadowless }

#declare Shiny = finish { ambient .05 diffuse .8 specular .5 roughness .02 }

sphere { <-27, -15, -28>, 11  pigment { srgb <.95, .45, .10> }  finish { Shiny } }         // before the sheet
torus { 21, 5  rotate 90*x  rotate 60*y  pigment { srgb <.15, .45, .80> }  finish { Shiny } }   // across it
box { <-75, -60, 40>, <75, 60, 42>                                                         // behind it
  pigment { checker srgb <.90, .86, .78>, srgb <.35, .45, .42>  scale 15 } }
