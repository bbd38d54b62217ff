// SPDX-License-Identifier: AGPL-3.0-or-later
// straddle.inc, and objects that contain parts of the aperture: Nest says which. Millimetres; the
// aperture's centre is at the origin, the sheet 25 mm before it. Declare=Rays=1: no picture, but
// groups.txt, which tells for each of the Pixels of rays.csv by a number (a bit an object) which of
// the objects contain the place where its ray starts.
#version 3.7;
#declare Glass = 1; #declare Bubble = 2; #declare Halves = 3; #declare Clouds = 4; #declare Bodies = 5; #declare Solids = 6;
global_settings { assumed_gamma 1 max_trace_level 8 }
#declare Placement = transform { translate z * 25 }
#declare Floor = -9.713;
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }

#switch (Nest)
#case (Glass) // two that overlap, and one in both
  #declare Containers = array[3] {
    box { <-60, -60, -9>, <0.3, 60, 5> texture { Clear } interior { ior 1.1 } rotate z * 7 }
    sphere { <2, 1, -1>, 5.1 texture { Clear } interior { ior 1.25 fade_power 1 fade_distance 6 fade_color <0.4, 0.8, 0.5> } }
    cylinder { <-7, -2, 0.5>, <7, -1, 0.5>, 1.6 texture { Clear } interior { ior 1.4 } } }
#break
#case (Bubble) // air, hollow and of index 1, within glass; and another that nothing is in
  #declare Containers = array[3] {
    sphere { <0, 0, 0>, 40 texture { Clear } interior { ior 1.3 } hollow scale <1, 1, 0.35> }
    sphere { <-1, 0.5, 0>, 6.2 texture { Clear } interior { ior 1 } hollow }
    box { <2, -9, -3>, <12, 9, 3> texture { Clear } hollow rotate y * 10 } }
#break
#case (Halves) // without end: a sea, a CSG of planes, an object turned inside out
  #declare Containers = array[3] {
    plane { y, -1.3 texture { Clear } interior { ior 1.12 } rotate z * -6 }
    intersection { plane { x, -2 } plane { -x, 5 } plane { z, 8 } texture { Clear } interior { ior 1.2 } hollow }
    sphere { <1, 5, 2>, 4 inverse texture { Clear } interior { ior 1.05 } } }
#break
#case (Clouds) // media, and a solid in fog, which keeps the fog out
  fog { distance 45 rgb <0.9, 0.8, 0.6> }
  media { method 3 samples 3 jitter 0 emission 0.004 absorption 0.002 }
  sphere { 0, 300 hollow inverse pigment { rgb 0.4 } finish { ambient 0.5 diffuse 0 } }
  #declare Containers = array[3] {
    box { <-60, -2.2, -7>, <60, 60, 9> texture { Clear } hollow interior { media { method 3 samples 3 jitter 0 absorption <0.06, 0.04, 0.02> } } }
    sphere { <3, 0, 0>, 4 texture { Clear } hollow interior { media { method 3 samples 3 jitter 0 emission <0.02, 0.05, 0.01> } } }
    box { <-60, -60, -4>, <-3.1, 60, 6> texture { Clear } } }
#break
#case (Bodies) // of many kinds: bounded, moved, joined
  #declare Containers = array[5] {
    box { -3, 3 texture { Clear } interior { ior 1.15 } rotate <10, 20, 30> }
    difference { sphere { <4, 3, 0>, 4.2 } cylinder { <4, 3, -9>, <4, 3, 9>, 1.7 } texture { Clear } interior { ior 1.3 } bounded_by { box { <-1, -2, -5>, <9, 8, 5> } } }
    union { sphere { <-5, -4, 0>, 2.4 } sphere { <-4, -6, 0.5>, 2.1 } texture { Clear } interior { ior 1.2 } split_union off }
    blob { threshold 0.5 sphere { <5, -4, 0>, 4, 1 } sphere { <7, -5, 1>, 3, 1 } texture { Clear } interior { ior 1.1 } scale <1, 0.9, 1> }
    merge { torus { 3, 1 rotate x * 80 } box { <-0.6, -3, -2>, <0.6, 3, 2> } texture { Clear } interior { ior 1.22 } hollow translate <-4, 3, 0> } }
  // Near, and round about: these contain nothing of it
  torus { 14, 2 rotate x * 90 texture { Clear } interior { ior 1.5 } translate z * -3 }
  box { <-30, -30, 4.2>, <30, 30, 4.4> texture { Clear } interior { ior 1.01 } }
#break
#case (Solids) // opaque ones, which POV-Ray counts too: from inside, their other sides are seen
  #declare Containers = array[2] {
    box { <-9, -60, -9>, <0.2, 60, 9> pigment { checker rgb 1 rgb <1, 0.3, 0> } finish { ambient 0.6 } }
    sphere { <3, 2, 0>, 4.4 pigment { rgbt <0.8, 0.9, 1, 0.7> } finish { ambient 0.2 refraction 1 ior 1.2 } } }
#break
#end

#ifdef (Rays)
  #fopen In "rays.csv" read
  #fopen Out "groups.txt" write
  #local Pixel = 0;
  #while (Pixel < Pixels)
    #read (In, Imaged, Ax, Ay, Az, Px, Py, Pz, Dx, Dy, Dz)
    #local Number = 0;
    #local Bit = 1;
    #local I = 0;
    #while (I < dimension_size(Containers, 1))
      // An inverse object contains, to POV-Ray's search, what is within its bounding box alone
      #local Low = min_extent(Containers[I]);
      #local High = max_extent(Containers[I]);
      #if (inside(Containers[I], <Ax, Ay, Az>) & Ax >= Low.x & Ay >= Low.y & Az >= Low.z & Ax <= High.x & Ay <= High.y & Az <= High.z) #local Number = Number + Bit; #end
      #local Bit = Bit * 2;
      #local I = I + 1;
    #end
    #write (Out, str(Number, 0, 0), "\n")
    #local Pixel = Pixel + 1;
  #end
  #fclose Out
  camera { location 0 }
#else
  #include "camera.inc"
  #include "straddle.inc"
  #local I = 0;
  #while (I < dimension_size(Containers, 1))
    object { Containers[I] }
    #local I = I + 1;
  #end
#end
