// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/replay/fit_part.h"

#include <algorithm>

namespace integral {

SheetPart part_seen(const View& view, const FrameMetadata& metadata)
{
    if (view.part.width > 0)
        return view.part;
    const double scale = metadata.projection ? metadata.projection->magnification() : 1;
    const Vec2 size = scale * size_of(metadata.film);
    return {{0, 0}, size.x, size.y};
}

FittedPicture fit_part(View& view, const FrameMetadata& metadata, double shape, Fit fit)
{
    SheetPart part = part_seen(view, metadata);
    const FittedPicture picture = fitted(part.width / part.height, shape, fit);
    if (picture.size.x == 1 && picture.size.y == 1)
        return picture;
    part.width /= picture.size.x;
    part.height /= picture.size.y;
    view.part = part;
    return picture;
}

FittedPicture fit_part_to_size(View& view, const FrameMetadata& metadata, Fit fit)
{
    View nearest = view;
    nearest.part = part_seen(view, metadata);
    set_view_size(nearest, metadata.film, std::max(view.width, view.height));
    const double shape = double(view.width) / view.height;
    if (nearest.width == view.width && nearest.height == view.height)
        return fitted(shape, shape, fit);
    return fit_part(view, metadata, shape, fit);
}

} // namespace integral
