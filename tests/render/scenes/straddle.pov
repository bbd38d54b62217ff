// SPDX-License-Identifier: AGPL-3.0-or-later
// straddle.inc by the camera in camera.inc, in the world that the declarations of the command line
// make: Scale scene units are a millimetre, and the world is turned by Turn about each axis.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
#ifndef (Scale) #declare Scale = 1; #end
#ifndef (Turn) #declare Turn = 0; #end
#declare Placement = transform { rotate <Turn * 0.5, Turn, Turn * 1.5> scale Scale translate Turn * Scale * <0.3, 0.1, -0.2> }
#include "camera.inc"
#ifdef (Front) // what depth_range leaves of it, for a camera without
  #declare Clip = box { <-1e4, -1e4, -Front>, <1e4, 1e4, Back> }
#end
#include "straddle.inc"
