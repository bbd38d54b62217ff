// SPDX-License-Identifier: AGPL-3.0-or-later
// Shows the picture frame.TYPE as it is, a pixel a pixel: what an unmodified POV-Ray reads in it.
// Declare=Type as below. Declare=Light: so many times as bright.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Light) #declare Light = 1; #end
camera { orthographic location <0.5, 0.5, -1> direction z right x up y }
box { 0, <1, 1, 0.01>
  pigment { image_map {
    #switch (Type)
    #case (0) png "frame.png" gamma srgb #break
    #case (1) ppm "frame.ppm" gamma srgb #break
    #case (2) tga "frame.tga" gamma srgb #break
    #case (3) bmp "frame.bmp" gamma srgb #break
    #case (4) jpeg "frame.jpg" gamma srgb #break
    #case (5) exr "frame.exr" gamma 1 #break
    #case (6) hdr "frame.hdr" gamma 1 #break
    #end
    once } }
  finish { ambient Light diffuse 0 } }
