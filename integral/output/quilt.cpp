// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/output/quilt.h"

#include <algorithm>

namespace integral {

Image quilt_of_views(std::vector<Image> views, ViewGrid grid)
{
    // Pictures are tiled from the top row on.
    for (int row = 0; row < grid.rows / 2; ++row)
        std::swap_ranges(views.begin() + row * grid.columns,
                         views.begin() + (row + 1) * grid.columns,
                         views.begin() + (grid.rows - 1 - row) * grid.columns);
    return tiled(views, grid.columns, 0);
}

std::vector<Image> views_of_quilt(const Image& quilt, ViewGrid grid)
{
    const int width = quilt.width / grid.columns, height = quilt.height / grid.rows;
    std::vector<Image> views;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            views.push_back(
                part_of(quilt, column * width, quilt.height - (row + 1) * height, width, height));
    return views;
}

} // namespace integral
