// SPDX-License-Identifier: AGPL-3.0-or-later
// A box lit by indirect light alone, about a sheet at z = 0, millimetres. Each point gathers few
// rays, so that it is noisy. The camera is in camera.inc.
#version 3.7;
global_settings { assumed_gamma 1
  radiosity { count 35 nearest_count 5 error_bound 0.3 recursion_limit 1 low_error_factor 0.8
    pretrace_start 0.08 pretrace_end 0.08 minimum_reuse 0.01 } }
#include "camera.inc"
#default { finish { ambient 0 diffuse 0.8 } }
box { <-14, -12, -30>, <14, 12, 14> hollow pigment { rgb <0.9, 0.85, 0.7> } }
box { <-13.9, -9, -25>, <-13.8, 11, 12> pigment { rgb 1 } finish { emission 1.5 diffuse 0 } }
sphere { <3, -3, 6>, 3 pigment { rgb <0.5, 0.7, 0.9> } }
box { <-5, -12, 3>, <-2, -1, 7> pigment { rgb <0.9, 0.5, 0.4> } }
