// SPDX-License-Identifier: AGPL-3.0-or-later
// A frame, and the glass that lies on it. One unit a millimetre, the sheet's poles at z = 0, the
// viewer at z < 0. Declare=Sheet=1 to 4: lenticular, slanted lenticular, square, hexagonal.
// Declare=Picture=1: an integral camera, whose picture is the frame.
//         Picture=2: instead of a frame a film whose every pixel is a grey of its own.
//         Picture=3 and Eye_X, Eye_Y, Eye_Distance: what an unmodified POV-Ray sees from there, a ray a pixel, of
//                   glass_film.png behind glass with curved front faces. Radius_Factor and Ior_Factor spoil the glass, Film_Gap
//                   moves the film away from it.
//         Picture=4 and the eye: the frame's scene itself, with neither film nor glass.
//
// In the third nothing comes from the integral camera or its tool but the film's pixels: the glass
// is spheres or cylinders, each clipped to its lens's cell, and the renderer's own Snell's law.
#version 3.7;

#declare Dpi = 300;
#declare Film_Columns = 480;
#declare Film_Rows = 312;
#declare Film_Width = Film_Columns * 25.4 / Dpi;
#declare Film_Height = Film_Rows * 25.4 / Dpi;
#declare Capture_Distance = 350;

// Pitch and thickness in mm, slant in degrees, anticlockwise; the offset keeps the sheet's centre
// from being a pole.
#switch (Sheet)
  #case (1) #declare Pitch = 1.27;  #declare Thickness = 3.08; #declare Ior = 1.6;   #declare Slant = 0;   #declare Offset = <0.11, 0>;    #break
  #case (2) #declare Pitch = 1.27;  #declare Thickness = 3.08; #declare Ior = 1.6;   #declare Slant = 12;  #declare Offset = <-0.2, 0>;    #break
  #case (3) #declare Pitch = 1.124; #declare Thickness = 3.23; #declare Ior = 1.675; #declare Slant = 0;   #declare Offset = <0.07, -0.1>; #break
  #case (4) #declare Pitch = 1.124; #declare Thickness = 3.23; #declare Ior = 1.675; #declare Slant = -9;  #declare Offset = <0.2, 0.13>;  #break
#end

global_settings { assumed_gamma 1 max_trace_level 20 }

#if (Picture >= 3)
  camera {   // its window is the film's rectangle on the plane of the poles
    location <Eye_X, Eye_Y, -Eye_Distance>
    direction <-Eye_X, -Eye_Y, Eye_Distance>
    right Film_Width*x
    up Film_Height*y
  }
#end

#if (Picture = 3)
  #ifndef (Radius_Factor) #declare Radius_Factor = 1; #end
  #ifndef (Ior_Factor) #declare Ior_Factor = 1; #end
  #ifndef (Film_Gap) #declare Film_Gap = 0; #end

  // Parallel light meets the film: at a surface of radius R, glass of index n has its focus n R /
  // (n - 1) behind the pole.
  #declare Radius = Radius_Factor * Thickness * (Ior - 1) / Ior;

  // The cell of the lens at the origin in the plane, and how far it reaches.
  #if (Sheet <= 2)
    #declare Reach = Pitch / 2;
    #declare Row_Spacing = 4 * (Film_Width + Film_Height);   // of one row, that covers the film
  #else
    #if (Sheet = 3)
      #declare Reach = Pitch / sqrt(2);
      #declare Row_Spacing = Pitch;
    #else
      #declare Reach = Pitch / sqrt(3);
      #declare Row_Spacing = Pitch * sqrt(3) / 2;
    #end
  #end
  // Only the front cap: from just before the pole to just behind the cell's farthest corner.
  #declare Front = -0.001;
  #declare Back = Radius - sqrt(Radius*Radius - Reach*Reach) + 0.001;

  #if (Sheet = 4)
    #declare Cell = intersection {
      #for (K, 0, 5)
        plane { x, Pitch / 2 rotate 60*K*z }
      #end
      plane { -z, -Front }
      plane { z, Back }
    }
  #else
    #declare Cell = box { <-Pitch/2, -Row_Spacing/2, Front>, <Pitch/2, Row_Spacing/2, Back> }
  #end

  // Open surfaces: what a ray enters through a cap it leaves only through a cap, and the film ends
  // it before.
  #if (Sheet <= 2)
    #declare Lens = cylinder { -Row_Spacing*y + Radius*z, Row_Spacing*y + Radius*z, Radius open clipped_by { Cell } }
  #else
    #declare Lens = sphere { Radius*z, Radius clipped_by { Cell } }
  #end

  // Lenses as far as an eye sees any, and some more.
  #declare Half = vlength(<Film_Width, Film_Height, 0>) / 2 + 3 * Pitch;
  #declare Rows = (Sheet <= 2 ? 0 : ceil(Half / Row_Spacing));
  #declare Columns = ceil(Half / Pitch);
  union {
    #for (J, -Rows, Rows)
      #for (I, -Columns, Columns)
        object { Lens translate <(I + (Sheet = 4 ? mod(abs(J), 2) / 2 : 0)) * Pitch, J * Row_Spacing, 0> }
      #end
    #end
    rotate Slant*z
    translate <Offset.u, Offset.v, 0>
    pigment { rgbt 1 }
    finish { ambient 0 diffuse 0 reflection 0 }
    interior { ior Ior * Ior_Factor }
  }

  // The film shines by itself; beyond its edge there is nothing.
  polygon {
    5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 0>
    pigment { image_map { png "glass_film.png" once } }
    finish { ambient 0 diffuse 0 emission 1 }
    translate <-0.5, -0.5, 0>
    scale <Film_Width, Film_Height, 1>
    translate (Thickness + Film_Gap) * z
  }
#end

#if (Picture = 2)
  camera { orthographic location -z direction z right Film_Columns*x up Film_Rows*y }
  // A cell a pixel, with its centre at the pixel's.
  plane { -z, 0 pigment { cells translate 0.5*z } finish { ambient 0 diffuse 0 emission 1 } }
#end

#if (Picture = 1)
  camera {
    integral
    #switch (Sheet)
      #range (1, 2) lens_sheet { lenticular pitch Pitch thickness Thickness ior Ior slant Slant offset Offset } #break
      #case (3) lens_sheet { square pitch Pitch thickness Thickness ior Ior slant Slant offset Offset } #break
      #case (4) lens_sheet { hexagonal pitch Pitch thickness Thickness ior Ior slant Slant offset Offset } #break
    #end
    film { dpi Dpi }
    location -Capture_Distance*z
    direction Capture_Distance*z
    right Film_Width*x
    up Film_Height*y
  }
#end

#if (Picture = 1 | Picture = 4)
  light_source { <-200, 300, -400> rgb 1 }
  sphere { <-8, 2, -12>, 6 pigment { checker rgb <0.9, 0.3, 0.2>, rgb <1, 0.8, 0.6> scale 2.5 } finish { ambient 0.2 diffuse 0.8 } }
  cylinder { <9, -20, -10>, <11, 20, 12>, 3 pigment { gradient y color_map { [0 rgb <0.1, 0.5, 0.2>] [1 rgb <0.5, 1, 0.4>] } scale 4 }
             finish { ambient 0.2 diffuse 0.8 } }
  torus { 5, 1.5 rotate -60*x translate <1, -6, 6> pigment { rgb <0.9, 0.8, 0.1> } finish { ambient 0.2 diffuse 0.7 phong 0.6 } }
  plane { -z, -40 pigment { checker rgb <0.1, 0.2, 0.6>, rgb <0.9, 0.9, 0.6> scale 11 } finish { ambient 0.6 diffuse 0.4 } }
#end
