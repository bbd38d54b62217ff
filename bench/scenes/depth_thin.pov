// SPDX-License-Identifier: AGPL-3.0-or-later
// For bench/depth_scores: thin rods and rings in front of one another.
#declare Shine = finish { specular 0 }
#include "depth_world.inc"
plane { -z, -60 Painted(Rough(50, <.3,.5,.2>, <.9,.9,.7>)) }
#for (I, 0, 8)
cylinder { <-48+12*I, -60, -30+5*mod(I*5,9)> <-44+11*I, 60, 10-4*mod(I*7,9)>, .6+.15*I Painted(Rough(8, <.8,.1+.1*I,.1>, <.2,.1,.1+.08*I>)) }
#end
#for (I, 0, 3)
torus { 9+3*I, .7 rotate 90*x rotate 20*I*y translate <-24+16*I, -20+14*I, -40+8*I> Painted(Rough(6, <.2,.3,.9>, <.8,.9,.9>)) }
#end
