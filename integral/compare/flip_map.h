// SPDX-License-Identifier: AGPL-3.0-or-later
// Pictures of a FLIP map.
#ifndef INTEGRAL_COMPARE_FLIP_MAP_H
#define INTEGRAL_COMPARE_FLIP_MAP_H

#include "integral/frame/image.h"

namespace integral {

/// The colour for a value of the map, as stored: from black (0) by violet and orange to a light
/// yellow (1), lighter all the way.
Colour flip_colour(float value);

/// The form of a map's picture: colours of 8 bits or, with `as_values`, the values as grey floats.
Image flip_map_form(int width, int height, bool as_values);

/// Rows of the map as a picture of that form.
Image flip_map_rows(const float* map, int width, int rows, bool as_values);

} // namespace integral

#endif
