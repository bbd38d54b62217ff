// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/views/quilt.h"

#include <algorithm>
#include <cstring>

namespace integral {

Image quilt_of_views(std::vector<Image> views, ViewGrid grid)
{
    // `tiled` fills the top row first, but views are numbered from the bottom row.
    for (int row = 0; row < grid.rows / 2; ++row)
        std::swap_ranges(views.begin() + row * grid.columns,
                         views.begin() + (row + 1) * grid.columns,
                         views.begin() + (grid.rows - 1 - row) * grid.columns);
    return tiled(views, grid.columns, 0);
}

std::vector<Image> views_of_quilt(const Image& form, ViewGrid grid,
                                  const std::function<void(Image&)>& read)
{
    const int width = form.width / grid.columns, height = form.height / grid.rows;
    std::vector<Image> views;
    for (int k = 0; k < grid.count(); ++k)
        views.push_back(blank_like(form, width, height));
    const int above = form.height - grid.rows * height; // unused rows of pixels above the top views
    const int most = rows_of_a_band(form);
    for (int first = 0; first < form.height; first += most) {
        Image band = blank_like(form, form.width, std::min(most, form.height - first));
        read(band);
        for (int y = 0; y < band.height; ++y) {
            const int row = first + y - above; // of pixels, counted from the top of the top views
            if (row < 0)
                continue;
            const int up = grid.rows - 1 - row / height;
            const std::size_t bytes = std::size_t(width) * form.channels * sample_bits(form) / 8;
            for (int column = 0; column < grid.columns; ++column)
                std::memcpy(row_bytes(views[std::size_t(up * grid.columns + column)], row % height),
                            row_bytes(band, y) + column * bytes, bytes);
        }
    }
    return views;
}

std::vector<Image> views_of_quilt(const Image& quilt, ViewGrid grid)
{
    int next = 0;
    return views_of_quilt(quilt, grid, [&](Image& band) {
        band = rows_of(quilt, next, band.height);
        next += band.height;
    });
}

} // namespace integral
