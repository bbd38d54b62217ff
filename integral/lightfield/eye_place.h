// SPDX-License-Identifier: AGPL-3.0-or-later
// Where a film point is seen: from which eye, and at which place of that eye's picture.
#ifndef INTEGRAL_LIGHTFIELD_EYE_PLACE_H
#define INTEGRAL_LIGHTFIELD_EYE_PLACE_H

#include "integral/lightfield/view_grid.h"
#include "integral/optics/lens_mapping.h"

#include <optional>

namespace integral {

struct EyePlace {
    Vec2 eye; ///< in the eyes' rectangle: 0 at its left and lower sides, 1 at the others; a side of
              ///< no length: the middle
    Vec2 place; ///< where the light leaves the sheet, mm in the sheet frame
};

/// Nothing where the film point images nothing. The eye may be past the rectangle's sides.
inline std::optional<EyePlace> eye_place(const SheetOptics& optics, const EyeGrid& eyes,
                                         Vec2 film_point)
{
    const auto ray = optics.map(film_point, LensMapping::automatic).ray;
    if (!ray)
        return std::nullopt;
    const double along = -eyes.distance / ray->direction.z;
    const Vec2 eye = ray->pole + along * Vec2{ray->direction.x, ray->direction.y};
    const auto part = [](double at, double side) { return side > 0 ? at / side + 0.5 : 0.5; };
    return EyePlace{{part(eye.x, eyes.zone.x), part(eye.y, eyes.zone.y)}, ray->pole};
}

} // namespace integral

#endif
