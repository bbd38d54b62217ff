// SPDX-License-Identifier: AGPL-3.0-or-later
// A grey picture of figures beside the frame.
#ifndef POVRAY_BASE_INTEGRALPICTURE_H
#define POVRAY_BASE_INTEGRALPICTURE_H

#include <string>
#include <vector>

namespace pov_base
{

/// Whether FILE can be written, as far as can be told beforehand.
bool May_Write_Integral_Picture(const std::string& file);

/// Writes width x height values, row by row, as linear light with 16 bits: FILE.exr as they are,
/// any other name as a PNG (sRGB). Values are cut to 0..1. Whole or not at all; false if it could
/// not be written.
bool Write_Integral_Picture(const std::string& file, int width, int height,
                            const std::vector<double>& values);

/// Writes width x height depths (mm), row by row, as channel Z of an OpenEXR file with the frame's
/// geometry in it; channel A is 0 where the depth is not a number, and 1 elsewhere. Whole or not at
/// all; false if it could not be written.
bool Write_Integral_Depth(const std::string& file, int width, int height,
                          const std::vector<float>& depths);

}

#endif
