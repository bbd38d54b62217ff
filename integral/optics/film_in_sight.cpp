// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/optics/film_in_sight.h"

namespace integral {

std::optional<FilmInSight> film_in_sight(const IntegralCamera& camera, Vec3 origin, Vec3 direction)
{
    constexpr double max_distance = 1e9; // pitches, as in SheetOptics::map
    Placement of_directions = camera.placement;
    of_directions.origin = {};
    const Vec3 start = sheet_from_scene(camera.placement, origin),
               along = sheet_from_scene(of_directions, direction);
    if (along.z == 0)
        return std::nullopt;
    // The line as the viewer sees it, from where it meets the sheet.
    const Line seen = image_of(camera.relief, Line{start, along});
    const SheetOptics& optics = camera.optics;
    const double limit = max_distance * optics.lattice().pitch();
    if (!(length(seen.origin) < limit))
        return std::nullopt;
    FilmInSight found;
    found.film_point = optics.film_point_seen({seen.origin.x, seen.origin.y}, -1 * seen.direction,
                                              &found.lens);
    return found;
}

} // namespace integral
