// SPDX-License-Identifier: AGPL-3.0-or-later
// World=1: a wall in the lenses' own plane, z = 0, in squares or stripes of the lenses' own cells
// (Pitch, in scene units): every ray through a lens sees that lens's colour. World=2: a sky whose
// colour depends on the direction alone: every lens's pixels show the same.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "camera.inc"
#if (World = 1)
  plane { -z, 0
    pigment { checker rgb <1, 0, 0> rgb <0, 1, 0> scale <Pitch, (Stripes ? 1e3 : Pitch), 1e3> translate <Pitch,
      (Stripes ? 1e3 : Pitch), 1e3> / 2 }
    finish { ambient 1 diffuse 0 } }
#else
  sky_sphere { pigment { checker rgb <1, 0.2, 0.1> rgb <0.1, 0.6, 0.9> scale 0.017 } }
#end
