// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes a geometry as the words of `camera { integral ... }`, for scenes and for Integral_Camera.
#ifndef INTEGRAL_SHEET_CAMERA_WORDS_H
#define INTEGRAL_SHEET_CAMERA_WORDS_H

#include "integral/frame/frame_metadata.h"

#include <string>

namespace integral {

/// lens_sheet { ... }. Numbers read back as the same double.
std::string sheet_words(const LensSheet& sheet);

/// film { ... }, with its dpi if that is a whole number in both directions, else with its pixel
/// pitch.
std::string film_words(const Film& film);

/// `fit 2`, for an existing scene that is put on a sheet: nine tenths of the picture then lie
/// within two depth budgets of the sheet, sharp or soft (depth_advice.h). `part`: factor of the
/// budgets, for words that stand with another film than the one that is seen.
std::string fit_words(double part = 1);

/// sheet_words and film_words; capture_aperture if it is finite and does not just fill the lenses;
/// viewing_distance. Leaves out a rendered frame's parallax, which belongs to its scene.
std::string camera_words(const FrameMetadata& geometry);

} // namespace integral

#endif
