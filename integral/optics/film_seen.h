// SPDX-License-Identifier: AGPL-3.0-or-later
// Computes the film points that eyes see at many points of the sheet, side by side.
#ifndef INTEGRAL_OPTICS_FILM_SEEN_H
#define INTEGRAL_OPTICS_FILM_SEEN_H

#include "integral/optics/lens_mapping.h"

#include <array>

namespace integral {

/// Points of the sheet, the points of the eye from which they are seen, and the film points seen
/// there. All in mm, in the sheet frame.
struct FilmSeenRun {
    static constexpr int length = 256;
    std::array<double, length> x, y, eye_x, eye_y, film_x, film_y;
};

/// Computes SheetOptics::film_point_seen for the first `number` points, bit for bit the same. All
/// entries of the run must be initialised; the film points of further ones become arbitrary.
/// `distance`: of all eyes in front of the sheet.
void film_points_seen(const SheetOptics& optics, double distance, int number, FilmSeenRun& run);

} // namespace integral

#endif
