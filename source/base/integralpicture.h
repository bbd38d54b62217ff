// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes per-pixel values, such as errors and depths, as grey pictures.
#ifndef POVRAY_BASE_INTEGRALPICTURE_H
#define POVRAY_BASE_INTEGRALPICTURE_H

#include <string>
#include <vector>

namespace pov_base
{

/// Returns why FILE cannot be written, for the user: its folder, IO restrictions, or that it is no
/// regular file. Empty if it probably can be: the test creates a temporary file in its folder and
/// deletes it.
std::string Find_Write_Error(const std::string& file);

/// Writes width x height values, row by row, clamped to 0..1: as linear light to FILE.exr, or as a
/// 16-bit sRGB PNG to any other name. The file appears only when it is complete. Returns an empty
/// text, or "FILE: cannot be written: " and the reason.
std::string Write_Integral_Picture(const std::string& file, int width, int height,
                                   const std::vector<double>& values);

/// Writes width x height depths (mm), row by row, as channel Z of an OpenEXR file with the frame's
/// geometry; channel A is 0 where the depth is NaN and 1 elsewhere. The attribute eyeDistances
/// contains `distances`, in scene units, from the plane of the scene's eye to the surfaces that it
/// sees. The file appears only when it is complete. Returns an empty text, or "FILE: cannot be
/// written: " and the reason.
std::string Write_Integral_Depth(const std::string& file, int width, int height,
                                 const std::vector<float>& depths,
                                 const std::vector<float>& distances);
}

#endif
