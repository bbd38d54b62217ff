// SPDX-License-Identifier: AGPL-3.0-or-later
// Glass, mirrors and highlights over a chequered floor. Refracted and reflected images appear at
// other depths than the bodies that show them.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
#include "viewpoint.inc"
light_source { <-200, 300, -400> rgb 1 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.85, 0.75>] [0.6 rgb <0.25, 0.4, 0.75>] } } }
plane { y, Floor pigment { checker rgb 0.9 rgb <0.25, 0.1, 0.08> scale 4 } finish { ambient 0.1 diffuse 0.7 reflection 0.15 } }
plane { -z, -80 pigment { wood color_map { [0 rgb <0.6, 0.65, 0.6>] [1 rgb <0.2, 0.3, 0.3>] } scale 5 } finish { ambient 0.2 } }

#declare Glass = texture { pigment { rgbf <0.95, 0.98, 1, 0.92> } finish { ambient 0 diffuse 0.05 specular 0.7 roughness 0.003 reflection 0.1 } }
#declare Mirror = texture { pigment { rgb <0.9, 0.8, 0.6> } finish { ambient 0 diffuse 0.15 specular 0.6 roughness 0.005 reflection 0.75 } }
sphere { <-4.5, -1.5, -12>, 3.3 texture { Glass } interior { ior 1.5 } }
sphere { <2.5, -3, -25>, 2 texture { Glass } interior { ior 1.33 } }
sphere { <4.5, 0, 10>, 5.5 texture { Mirror } }
#declare R = seed(3);
#for (I, 1, 40)
  sphere { <(rand(R) - 0.5)*28, (rand(R) - 0.4)*16, -30 + 85*rand(R)>, 0.5 + 0.9*rand(R)
    #if (mod(I, 2)) texture { Mirror } #else texture { Glass } interior { ior 1.5 } #end }
#end
