// SPDX-License-Identifier: AGPL-3.0-or-later
// A scene behind a panel's window of Width x Height mm at z = 0. The eye is Distance mm in front of
// it, EyeX mm to the right of its centre; the window remains the image plane (oblique projection).
#version 3.7;
global_settings { assumed_gamma 1.0 }
#ifndef (EyeX) #declare EyeX = 0; #end
camera {
  perspective
  location <EyeX, 0, -Distance> direction <-EyeX, 0, Distance>
  right Width*x up Height*y
}
light_source { <-200, 300, -400> rgb 1 }
background { rgb <.2, .25, .35> }
sphere { <0, 2, 0>, 8 texture { pigment { rgb <1, .5, .1> } finish { specular .4 roughness .05 } } }
sphere { <-8, -9, -6>, 3.5 pigment { rgb <.2, .6, 1> } }
torus { 5, 1 rotate 60*x translate <7, -10, 4> pigment { rgb <.3, .8, .3> } }
plane { z, 14 pigment { checker rgb 1, rgb .35 scale 5 } }
