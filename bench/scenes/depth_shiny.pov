// SPDX-License-Identifier: AGPL-3.0-or-later
// For bench/depth_scores: mirroring balls on a mirroring floor.
#declare Shine = finish { specular .8 roughness .01 reflection { .02, .25 } phong .3 }
#include "depth_world.inc"
plane { -z, -75 Painted(Rough(60, <.3,.3,.4>, <.8,.7,.6>)) }
plane { y, -40 rotate -10*x Painted(pigment { checker rgb <.7,.65,.6> rgb <.25,.2,.2> scale 9 }) }
#for (I, 0, 4)
sphere { <-36+18*I, -26+6*mod(I*2,5), -30+18*I>, 9+mod(I,3)*2 Painted(Rough(18, <.9-.15*I,.3,.1+.15*I>, <.3,.1+.1*I,.4>)) }
#end
