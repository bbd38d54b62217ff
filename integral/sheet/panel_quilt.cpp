// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/sheet/panel_quilt.h"

#include <algorithm>
#include <cmath>

namespace integral {

namespace {

constexpr int most_side = 8192;

/// Whether two panels have the same pixels, of the same size to a twentieth.
bool have_same_pixels(const Panel& a, const Panel& b)
{
    return a.film.width == b.film.width && a.film.height == b.film.height &&
           std::fabs(a.film.pixel_pitch.x / b.film.pixel_pitch.x - 1) < 0.05;
}

const RecommendedQuilt* recommended_for(const Panel& panel)
{
    const auto& all = recommended_quilts();
    auto found = std::find_if(all.begin(), all.end(),
                              [&](const RecommendedQuilt& one) { return one.panel == panel.name; });
    if (found == all.end())
        found = std::find_if(all.begin(), all.end(), [&](const RecommendedQuilt& one) {
            return have_same_pixels(panel, *panel_named(one.panel));
        });
    return found == all.end() ? nullptr : &*found;
}

} // namespace

const std::vector<RecommendedQuilt>& recommended_quilts()
{
    static const std::vector<RecommendedQuilt> all = {
        {"looking-glass-portrait", {{8, 6}, 3360, 3360}},
        {"looking-glass-go", {{11, 6}, 4092, 4092}},
        {"looking-glass-16-landscape", {{8, 6}, 7680, 4320}},
        {"looking-glass-16-landscape", {{7, 7}, 5999, 5999}},
        {"looking-glass-16-portrait", {{11, 6}, 5995, 6000}},
        {"looking-glass-32-landscape", {{7, 7}, 8190, 8190}},
        {"looking-glass-65", {{8, 9}, 8192, 8192}},
        {"looking-glass-8-9", {{5, 9}, 2048, 2048}},
        {"looking-glass-8-9", {{5, 9}, 4096, 4096}},
        {"looking-glass-15-6", {{5, 9}, 4096, 4096}},
    };
    return all;
}

PanelQuilt quilt_for(const Panel& panel, const std::optional<ViewGrid>& tiles)
{
    const RecommendedQuilt* recommended = recommended_for(panel);
    if (recommended && (!tiles || (tiles->columns == recommended->quilt.tiles.columns &&
                                   tiles->rows == recommended->quilt.tiles.rows)))
        return recommended->quilt;
    const ViewGrid grid = tiles.value_or(ViewGrid{8, 6});
    const Vec2 size = size_of(panel.film);
    const double pixels = 1.5 * 3 * panel.film.width * panel.film.height,
                 height = std::sqrt(pixels / grid.count() * size.y / size.x),
                 width = height * size.x / size.y,
                 fits = std::min(
                     {1.0, most_side / (width * grid.columns), most_side / (height * grid.rows)});
    const auto whole = [&](double side, int number) {
        return number *
               std::clamp(int(std::lround(fits * side)), 1, std::max(1, most_side / number));
    };
    return {grid, whole(width, grid.columns), whole(height, grid.rows)};
}

} // namespace integral
