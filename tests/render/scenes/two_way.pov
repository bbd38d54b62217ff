// SPDX-License-Identifier: AGPL-3.0-or-later
// The thesis's forward and reversed tracing (3.6.1), literally, for an unmodified POV-Ray. Every
// line of rays.csv is a pixel's path: the aperture point A, the point P on the sheet, the direction
// from A into the scene. From P the path is followed towards the viewer, and of the surfaces in
// front of the sheet the furthest from it is looked for; there the direction is reversed and the
// ray traced back into the scene. Where there is none, the ray is traced from the sheet forwards.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
#declare Placement = transform { scale 1 }
#include "straddle.inc"

#declare In_Front = 0;
#macro Pixel_Face(A, P, D)
  #local Outwards = -vnormalize(D);
  #local Reach = vlength(A - P);
  #local From = P;
  #local Start = P;
  #local Searching = yes;
  #while (Searching)
    #local Normal = <0, 0, 0>;
    #local Hit = trace(Straddle, From, Outwards, Normal);
    #if (vlength(Normal) = 0 | vlength(Hit - P) > Reach)
      #local Searching = no;
    #else
      #local Start = Hit + Outwards * 0.002; // before that surface, on the viewer's side
      #local From = Hit + Outwards * 0.001;
    #end
  #end
  #if (vlength(Start - P) > 0) #declare In_Front = In_Front + 1; #end
  // A face whose centroid is Start and whose normal is the reversed direction.
  #local U = vnormalize(vcross(Outwards, (abs(Outwards.x) < 0.6 ? x : y)));
  #local V = vcross(-Outwards, U);
  triangle { Start + U, Start - U / 2 - V * sqrt(3) / 2, Start - U / 2 + V * sqrt(3) / 2 }
#end

#fopen Rays "rays.csv" read
camera {
  mesh_camera { 1 0 mesh {
    #declare Pixel = 0;
    #while (Pixel < image_width * (image_height - 1))
      #read (Rays, Imaged, Ax, Ay, Az, Px, Py, Pz, Dx, Dy, Dz)
      #if (Imaged) Pixel_Face(<Ax, Ay, Az>, <Px, Py, Pz>, <Dx, Dy, Dz>)
      #else triangle { <0, 0, -25>, <0, 1, -25>, <1, 0, -25> } // these pixels are masked
      #end
      #declare Pixel = Pixel + 1;
    #end
  } }
  location 0
}
#warning concat("pixels with a surface in front of the sheet: ", str(In_Front, 0, 0), "\n")
