// SPDX-License-Identifier: AGPL-3.0-or-later
//
// tutorial_hexagonal.pov -- a sheet of hexagonal lenses: the densest packing of round lenses
//
//   povray-integral +Itutorial_hexagonal.pov +W1200 +H900 +Otutorial_hexagonal.png
//   integral replay tutorial_hexagonal.png --eye -40,40,350 -o view.png
//
// The lenses are in rows along x, and every other row is shifted by half a pitch, as in a honeycomb. The cell of a lens
// is a hexagon with two vertical sides, which a round lens fills better than a square.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera {
  integral
  lens_sheet { hexagonal pitch 1 thickness 2.9 ior 1.6 }       // 1 mm from lens to lens, rows 0.866 mm apart
  film { dpi 300 }
  location <0, 0, -350>
  look_at <0, 0, 0>
  right x*image_width/image_height
  angle 2*degrees(atan2(101.6/2, 350))
}
// Again 1 unit is 1 mm, the sheet is the plane z = 0, and the viewer is at z = -350.
// For a sheet that is not laid straight, `slant DEGREES` turns the lattice and `offset <x, y>` (mm) moves it.

light_source { <-200, 300, -400> rgb 1 }
light_source { <300, 100, -300> rgb .35 shadowless }

#declare Shiny = finish { ambient .05 diffuse .8 specular .5 roughness .02 }

sphere { <-27, -15, -28>, 11  pigment { srgb <.30, .65, .25> }  finish { Shiny } }         // before the sheet
torus { 21, 5  rotate 90*x  rotate 60*y  pigment { srgb <.80, .25, .50> }  finish { Shiny } }   // across it
box { <-75, -60, 40>, <75, 60, 42>                                                         // behind it
  pigment { hexagon srgb <.92, .87, .75>, srgb <.60, .50, .40>, srgb <.78, .66, .50>  rotate 90*x  scale 12 } }
