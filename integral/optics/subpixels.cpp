// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/optics/subpixels.h"

#include <cmath>

namespace integral {

bool same_layout(const Subpixels& a, const Subpixels& b)
{
    if (a.order != b.order || a.pattern != b.pattern || a.number != b.number)
        return false;
    for (int cell = 0; cell < a.number; ++cell)
        for (int channel = 0; channel < 3; ++channel)
            if (a.cell[cell][channel].x != b.cell[cell][channel].x || a.cell[cell][channel].y != b.cell[cell][channel].y)
                return false;
    return true;
}

int cell_of(const Subpixels& subpixels, int column, int row)
{
    const int odd_column = column & 1, odd_row = row & 1;
    int cell = 0;
    switch (subpixels.pattern) {
    case CellPattern::same: break;
    case CellPattern::checkerboard: cell = odd_column ^ odd_row; break;
    case CellPattern::columns: cell = odd_column; break;
    case CellPattern::rows: cell = odd_row; break;
    case CellPattern::staggered: cell = (row + 2 * odd_column) & 3; break;
    }
    return subpixels.number > 0 ? cell % subpixels.number : 0;
}

Vec2 subpixel_shift(const Subpixels& subpixels, Vec2 pixel, int channel)
{
    const double third = (channel - 1) / 3.0;
    switch (subpixels.order) {
    case Subpixels::none: break;
    case Subpixels::rgb: return {third, 0};
    case Subpixels::bgr: return {-third, 0};
    case Subpixels::vrgb: return {0, third};
    case Subpixels::vbgr: return {0, -third};
    case Subpixels::cells: {
        const int cell = cell_of(subpixels, int(std::floor(pixel.x)), int(std::floor(pixel.y)));
        const Vec2 shift = subpixels.cell[cell][channel];
        return {shift.x, -shift.y};
    }
    }
    return {0, 0};
}

Vec2 subpixel_size(const Subpixels& subpixels)
{
    switch (subpixels.order) {
    case Subpixels::none: break;
    case Subpixels::rgb:
    case Subpixels::bgr: return {1 / 3.0, 1};
    case Subpixels::vrgb:
    case Subpixels::vbgr: return {1, 1 / 3.0};
    case Subpixels::cells: return {std::sqrt(1 / 3.0), std::sqrt(1 / 3.0)};
    }
    return {1, 1};
}

PixelPlace pixel_of_nearest_subpixel(const Subpixels& subpixels, Vec2 pixel, int channel)
{
    if (subpixels.order != Subpixels::cells) {
        const Vec2 unshifted = pixel - subpixel_shift(subpixels, pixel, channel);
        return {int(std::floor(unshifted.x)), int(std::floor(unshifted.y))};
    }
    // A subpixel may be as far as a pixel from its pixel's centre.
    const int column = int(std::floor(pixel.x)), row = int(std::floor(pixel.y));
    PixelPlace nearest{column, row};
    double least = 0;
    bool found = false;
    for (int j = row - 2; j <= row + 2; ++j)
        for (int i = column - 2; i <= column + 2; ++i) {
            const Vec2 centre{i + 0.5, j + 0.5};
            const Vec2 away = centre + subpixel_shift(subpixels, centre, channel) - pixel;
            const double square = dot(away, away);
            if (!found || square < least) {
                found = true;
                least = square;
                nearest = {i, j};
            }
        }
    return nearest;
}

} // namespace integral
