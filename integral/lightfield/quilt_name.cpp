// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/quilt_name.h"

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

std::string without_grid(const std::string& path)
{
    return grid_in_name(path) ? path.substr(0, path.rfind("_qs")) + path.substr(path.rfind('.'))
                              : path;
}

} // namespace integral
