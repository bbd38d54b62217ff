// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes a geometry as the words of `camera { integral ... }`, for scenes and for Integral_Camera.
#ifndef INTEGRAL_LIGHTFIELD_CAMERA_WORDS_H
#define INTEGRAL_LIGHTFIELD_CAMERA_WORDS_H

#include "integral/lightfield/frame_metadata.h"

#include <string>

namespace integral {

/// lens_sheet { ... }. Numbers read back as the same double.
std::string sheet_words(const LensSheet& sheet);

/// film { ... }: by its dpi where they are a whole number in both directions, else by its pixel
/// pitch.
std::string film_words(const Film& film);

/// `fit 2`, for scenes that are put on a sheet as they are: nine tenths of the picture within two
/// depth budgets, sharp or soft.
std::string fit_words();

/// sheet_words and film_words; capture_aperture where it is limited and not what fills the lenses;
/// and viewing_distance. The parallax of a rendered frame is its scene's and is left out.
std::string camera_words(const FrameMetadata& geometry);

} // namespace integral

#endif
