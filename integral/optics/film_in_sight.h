// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds the film point that a line of sight in the scene shows: the inverse of sight_line.
#ifndef INTEGRAL_OPTICS_FILM_IN_SIGHT_H
#define INTEGRAL_OPTICS_FILM_IN_SIGHT_H

#include "integral/optics/camera.h"

namespace integral {

/// A film point, and the lens through which it is seen.
struct FilmInSight {
    Vec2 film_point; ///< mm; may be outside the film
    LensIndex lens;
};

/// Inverse of sight_line for pole rays: the film point seen along a line in the scene, through the
/// lens whose cell the line crosses. `origin`: any point of the line; `direction`: of any length
/// and either sense. Empty if the line is parallel to the sheet, or meets it more than 10^9 pitches
/// from its centre. Not for a camera with a projection lens.
std::optional<FilmInSight> film_in_sight(const IntegralCamera& camera, Vec3 origin, Vec3 direction);

} // namespace integral

#endif
