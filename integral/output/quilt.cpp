// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/output/quilt.h"

#include <algorithm>
#include <cstdio>

namespace integral {

std::optional<ViewGrid> grid_in_name(const std::string& path)
{
    const std::size_t end = path.rfind("_qs"), dot = path.find_last_of('.');
    if (end == std::string::npos || dot == std::string::npos || dot < end)
        return std::nullopt;
    ViewGrid grid;
    int aspect = 0, whole = 0; // where the aspect begins, and how much of the end has been read
    const std::string text = path.substr(end, dot - end);
    if (std::sscanf(text.c_str(), "_qs%4dx%4da%n%*[0-9.]%n", &grid.columns, &grid.rows, &aspect,
                    &whole) < 2 ||
        whole <= aspect || std::size_t(whole) != text.size())
        return std::nullopt;
    return grid;
}

std::string quilt_name(const std::string& path, ViewGrid grid, double aspect)
{
    if (grid_in_name(path))
        return path;
    char end[64];
    std::snprintf(end, sizeof end, "_qs%dx%da%.4g", grid.columns, grid.rows, aspect);
    const std::size_t dot = path.find_last_of('.');
    return path.substr(0, dot) + end + path.substr(dot);
}

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
