// SPDX-License-Identifier: AGPL-3.0-or-later
// straddle.inc with what depends on where a ray starts and on the rest of POV-Ray: Effect says
// which. Millimetres; the aperture's centre is at the origin and the sheet 25 mm before it, because
// a mesh_camera's location has to stay 0.
#version 3.7;
#declare Fog = 1; #declare Media = 2; #declare Photons = 3; #declare Radiosity = 4; #declare Inside = 5;
#declare Fading = 7; #declare Sky = 8; #declare Dull = 9;
global_settings {
  assumed_gamma 1 max_trace_level 8
  #if (Effect = Photons) photons { spacing 0.15 jitter 0 } #end
  #if (Effect = Radiosity)
    ambient_light 0.3
    radiosity { count 120 error_bound 0.6 nearest_count 8 recursion_limit 1 pretrace_start 0.08 pretrace_end 0.02 minimum_reuse 0.01 }
  #end
}
#declare Placement = transform { translate z * 25 }
#declare Floor = -9.713; // below the aperture: what contains a part of it is in containers.pov
#include "camera.inc"
#include "straddle.inc"
#switch (Effect)
#case (Fog)
  fog { distance 45 rgb <0.9, 0.8, 0.6> }
  fog { fog_type 2 distance 8 rgb <0.6, 0.7, 1> fog_offset -9 fog_alt 1.5 up y }
#break
#case (Media)
  media { method 3 samples 4 jitter 0 emission 0.03 absorption 0.01
    density { spherical color_map { [0 rgb 0] [0.5 rgb <0.4, 0.6, 1>] [1 rgb <1, 0.9, 0.4>] } scale 22 translate z * 20 } }
  // Something at the end of every ray
  sphere { 0, 200 inverse pigment { rgb 0.4 } finish { ambient 0.5 diffuse 0 } }
#break
#case (Photons)
  sphere { <-1.5, -7, 23>, 1.6 pigment { rgbt <1, 0.95, 0.9, 0.95> } finish { ambient 0 diffuse 0.05 } interior { ior 1.6 }
    photons { target refraction on reflection off } }
  light_source { <-8, 25, 15>, rgb 1.2 photons { refraction on } }
#break
#case (Inside)
  box { <-60, -60, -7>, <60, 60, 4.3> pigment { rgbt <0.9, 1, 0.95, 1> } finish { ambient 0 diffuse 0 } rotate <5, 8, 0>
    interior { ior 1.25 } }
#break
#case (Fading) // a medium that contains the whole aperture and dims what is seen through it
  box { <-60, -60, -7>, <60, 60, 12> pigment { rgbt 1 } finish { ambient 0 diffuse 0 } hollow
    interior { media { method 3 samples 3 jitter 0 absorption <0.06, 0.04, 0.02> } } }
#break
#case (Sky)
  sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.7>] [1 rgb <0.1, 0.2, 0.7>] } scale 0.7 } }
  rainbow { angle 30 width 12 distance 200 direction <0.1, -0.1, 1> up y color_map { [0 rgbt <1, 0, 0, 0.8>] [0.5 rgbt <0, 1, 0, 0.6>] [1 rgbt <0, 0, 1, 0.8>] } }
#break
#end
