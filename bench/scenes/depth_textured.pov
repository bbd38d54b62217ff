// SPDX-License-Identifier: AGPL-3.0-or-later
// For bench/depth_scores: texture everywhere, surfaces in front of, across and behind the sheet.
#declare Shine = finish { specular 0 }
#include "depth_world.inc"
plane { -z, -70 Painted(Rough(60, <.2,.3,.5>, <.9,.8,.6>)) }
plane { y, -45 rotate -12*x Painted(Rough(40, <.6,.3,.2>, <.3,.5,.3>)) }
sphere { <-18, 5, 10>, 22 Painted(Rough(25, <.8,.2,.2>, <.2,.1,.6>)) }
box { <-10,-40,-10> <10,0,10> rotate 35*y translate <22,-2,-20> Painted(Rough(30, <.1,.5,.3>, <.9,.9,.4>)) }
cylinder { <-45,-40,40> <-30,45,30>, 3 Painted(Rough(12, <.9,.9,.9>, <.2,.2,.2>)) }
torus { 12, 3 rotate 60*x translate <20,26,0> Painted(Rough(14, <.9,.5,.1>, <.3,.1,.0>)) }
