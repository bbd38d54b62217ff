// SPDX-License-Identifier: AGPL-3.0-or-later
// A checkered wall that shines with Light times what its colours say, behind a black ball. With
// Light=1 it is as bright as a file can hold; more is clipped to just that. Glow: the wall has one
// colour alone, which lets what is behind it through.
#version 3.7;
#ifndef (Gamma) #declare Gamma = 1; #end
global_settings { assumed_gamma Gamma }
#ifndef (Light) #declare Light = 1; #end
#ifdef (Glow)
  plane { z, 20 pigment { rgbt <1, 0.1, 0, 0.5> } finish { ambient Light diffuse 0 } }
#else
  plane {
    z, 20
    pigment { checker rgb <1, 1, 0> rgb <1, 0, 1> scale 0.5 }
    finish { ambient Light diffuse 0 }
  }
  sphere { 0, 3 pigment { rgb 0 } }
#end
#include "camera.inc"
