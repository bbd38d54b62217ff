// SPDX-License-Identifier: AGPL-3.0-or-later
// For bench/depth_scores: surfaces with hardly any texture.
#declare Shine = finish { specular .2 roughness .05 }
#include "depth_world.inc"
plane { -z, -70 Painted(pigment { bozo scale 30 color_map { [0 rgb <.5,.55,.7>] [1 rgb <.62,.6,.7>] } }) }
plane { y, -45 rotate -12*x Painted(pigment { checker rgb <.55,.5,.45> rgb <.48,.42,.4> scale 15 }) }
sphere { <-18, 5, 10>, 22 Painted(pigment { wrinkles scale 20 color_map { [0 rgb <.7,.3,.2>] [1 rgb <.8,.42,.3>] } }) }
box { <-10,-40,-10> <10,0,10> rotate 35*y translate <22,-2,-20> Painted(pigment { rgb <.3,.6,.4> }) }
cone { <25,10,30> 14 <25,40,30> 0 Painted(pigment { gradient y scale 8 color_map { [0 rgb <.8,.7,.3>] [1 rgb <.7,.5,.3>] } }) }
