// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds the eye position that sees a film point, and the place where the point's light leaves the
// sheet.
#ifndef INTEGRAL_FRAME_EYE_PLACE_H
#define INTEGRAL_FRAME_EYE_PLACE_H

#include "integral/frame/view_grid.h"
#include "integral/optics/lens_mapping.h"

#include <optional>

namespace integral {

struct EyePlace {
    Vec2 eye;   ///< position in the eyes' rectangle: (0, 0) at its lower left corner, (1, 1) at its
                ///< upper right; 0.5 along a side of length 0
    Vec2 place; ///< where the light leaves the sheet, mm in the sheet frame
};

/// The EyePlace of a film point; nothing if no lens images the point. The eye may be outside the
/// rectangle.
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
