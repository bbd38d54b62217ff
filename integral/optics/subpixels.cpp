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
            if (a.cell[cell][channel].x != b.cell[cell][channel].x ||
                a.cell[cell][channel].y != b.cell[cell][channel].y)
                return false;
    return true;
}

namespace {

/// The number of different cells in a pattern.
int period(CellPattern pattern)
{
    switch (pattern) {
    case CellPattern::same: break;
    case CellPattern::checkerboard:
    case CellPattern::columns:
    case CellPattern::rows: return 2;
    case CellPattern::staggered: return 4;
    }
    return 1;
}

} // namespace

Subpixels mirrored(const Subpixels& subpixels, int columns, int rows, bool x, bool y)
{
    Subpixels result = subpixels;
    switch (subpixels.order) {
    case Subpixels::none: break;
    case Subpixels::rgb: result.order = x ? Subpixels::bgr : Subpixels::rgb; break;
    case Subpixels::bgr: result.order = x ? Subpixels::rgb : Subpixels::bgr; break;
    case Subpixels::vrgb: result.order = y ? Subpixels::vbgr : Subpixels::vrgb; break;
    case Subpixels::vbgr: result.order = y ? Subpixels::vrgb : Subpixels::vbgr; break;
    case Subpixels::cells:
        // The mirror image of a pattern is the same pattern with its cells in another order. One
        // pixel of each cell determines that order.
        result.number = period(subpixels.pattern);
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 2; ++column) {
                PixelCell cell = subpixels.cell[cell_of(
                    subpixels, x ? columns - 1 - column : column, y ? rows - 1 - row : row)];
                for (Vec2& place : cell)
                    place = {x ? 0 - place.x : place.x, y ? 0 - place.y : place.y};
                result.cell[cell_of(result, column, row)] = cell;
            }
        break;
    }
    return result;
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
    // A subpixel may be up to one pixel away from its pixel's centre.
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
