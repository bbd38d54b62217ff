// SPDX-License-Identifier: AGPL-3.0-or-later
// Places the eyes of a quilt's views.
#ifndef INTEGRAL_FRAME_VIEW_EYES_H
#define INTEGRAL_FRAME_VIEW_EYES_H

#include "integral/frame/view_grid.h"

namespace integral {

/// The eye of a view, mm from the sheet's axis, to the right and up. `directions`: the numbers of
/// views across and up (directions_of).
inline Vec2 eye_of_view(const EyeGrid& eyes, ViewGrid directions, int view)
{
    const auto place = [](int k, int count) { return (k + 0.5) / count - 0.5; };
    return {place(view % directions.columns, directions.columns) * eyes.zone.x,
            place(view / directions.columns, directions.rows) * eyes.zone.y};
}

} // namespace integral

#endif
