// SPDX-License-Identifier: AGPL-3.0-or-later
// The words as macros with and without parameters, as parameters and as locals of macros.
#version 3.7;
global_settings { assumed_gamma 1 }
#macro integral() <1, 3, -8> #end
#macro lens_sheet(pitch, slant) <pitch, slant, pitch - slant> #end
#macro film(dpi)
  #local pixel_pitch = dpi / 100;
  #local units_per_mm = pixel_pitch * 2;
  <pixel_pitch, units_per_mm, 0>
#end
#macro closest(auto, accurate) (auto < accurate ? auto : accurate) #end
#macro capture_aperture(A) sphere { A, 0.6 pigment { rgb lens_sheet(0.9, 0.4) } } #end
#macro pseudoscopic() rotate y * 30 scale 1.1 #end
#macro lens_mapping(exhaustive) #if (exhaustive > 0) lens_mapping(exhaustive - 1) capture_aperture(<exhaustive - 2, exhaustive / 3, 0>) #end #end
#macro beam_samples(N, depth_range) #local I = 0; #while (I < N) depth_range #local I = I + 1; #end #end
camera { location integral() look_at film(50) angle closest(45, 60) right x * 4 / 3 }
light_source { <5, 9, -9> rgb 1 }
union { lens_mapping(4) pseudoscopic() }
plane { y, -1 pigment { hexagon rgb 0.9 rgb 0.6 rgb 0.3 } }
beam_samples(2, sphere { <-2, 0, -1>, 0.4 pigment { rgb <0.1, 0.8, 0.3> } })
