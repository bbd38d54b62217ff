// SPDX-License-Identifier: AGPL-3.0-or-later
// Declare=Balls: so many, of glass and not, and a wall without end. The camera is camera.inc's, or
// without Integral=1 a perspective one.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
#ifdef (Integral) #include "camera.inc" #else camera { location <0, 0, -300> look_at 0 angle 10 } #end
light_source { <-200, 300, -400> rgb 1 }
plane { -z, -45 pigment { checker rgb 0.9 rgb <0.3, 0.5, 0.7> scale 4.7 } }
#declare R = seed(3);
#for (I, 1, Balls)
  sphere { <(rand(R) - 0.5)*70, (rand(R) - 0.5)*50, (rand(R) - 0.5)*60>, 0.5 + 1.5*rand(R)
           pigment { rgbt <0.9, rand(R), rand(R), 0.8*mod(I, 2)> } finish { specular 0.4 reflection 0.1 } interior { ior 1.3 } }
#end
