// SPDX-License-Identifier: AGPL-3.0-or-later
// For bench/depth_scores: one slanted plane, from 50 mm in front of the sheet at the bottom to more
// than 110 mm behind it at the top: how depth's error grows with depth.
#declare Shine = finish { specular 0 }
#include "depth_world.inc"
plane { <0, 1.6, -1>, -30/sqrt(1 + 1.6*1.6) Painted(Rough(25, <.8,.3,.2>, <.2,.3,.7>)) }
