// SPDX-License-Identifier: AGPL-3.0-or-later
// straddle.inc under a large area light, above planes that hardly a ray meets but every ray is tried
// with: slow enough to be interrupted. Declare how many Planes (+A shares the area lights' shadows, and
// needs more of them).
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
#declare Placement = transform { scale 1 }
#include "camera.inc"
#include "straddle.inc"
light_source { <2, 14, -9>, rgb 0.3 area_light x * 6, z * 6, 9, 9 }
light_source { <-6, 10, 12>, rgb 0.2 area_light x * 6, y * 6, 9, 9 }
#declare Depth = 100;
#while (Depth < 100 + Planes)
  plane { y, -Depth no_shadow }
  #declare Depth = Depth + 1;
#end
