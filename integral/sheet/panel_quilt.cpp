// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/sheet/panel_quilt.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace integral {

namespace {

constexpr int most_side = 8192;

/// Whether two panels have the same pixels, of the same size to a twentieth.
bool have_same_pixels(const Panel& a, const Panel& b)
{
    return a.film.width == b.film.width && a.film.height == b.film.height &&
           std::fabs(a.film.pixel_pitch.x / b.film.pixel_pitch.x - 1) < 0.05;
}

/// Whether a recommended quilt is meant for a panel: by its name or, as `by_name` is false, by its
/// pixels.
bool is_for(const RecommendedQuilt& one, const Panel& panel, bool by_name)
{
    return by_name ? one.panel == panel.name : have_same_pixels(panel, *panel_named(one.panel));
}

/// The quilt that a display reports, or the newest recommended one of a panel; with `tiles`, the
/// one of that grid. Nothing if there is none.
std::optional<PanelQuilt> recommended_for(const Panel& panel, const std::optional<ViewGrid>& tiles)
{
    const auto is_requested = [&](const PanelQuilt& quilt) {
        return !tiles || (tiles->columns == quilt.tiles.columns && tiles->rows == quilt.tiles.rows);
    };
    if (panel.calibration && panel.calibration->quilt && is_requested(*panel.calibration->quilt))
        return panel.calibration->quilt;
    const auto& all = recommended_quilts();
    for (const bool by_name : {true, false}) {
        const auto match = std::find_if(all.begin(), all.end(), [&](const RecommendedQuilt& one) {
            return is_for(one, panel, by_name) && is_requested(one.quilt);
        });
        if (match != all.end())
            return match->quilt;
    }
    return std::nullopt;
}

/// The quilt with `parts` times fewer pixels across and down.
PanelQuilt reduced(PanelQuilt quilt, int parts)
{
    if (parts == 1)
        return quilt;
    const auto side = [&](int pixels, int tiles) {
        return tiles * std::max(1, int(std::lround(double(pixels / tiles) / parts)));
    };
    return {quilt.tiles, side(quilt.width, quilt.tiles.columns),
            side(quilt.height, quilt.tiles.rows)};
}

/// A quilt of tiles of the panel's shape.
PanelQuilt quilt_of_tiles(const Panel& panel, ViewGrid grid)
{
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

std::optional<QuiltSize> quilt_size(const std::string& name)
{
    if (name == "draft")
        return QuiltSize::draft;
    if (name == "good")
        return QuiltSize::good;
    if (name == "best")
        return QuiltSize::best;
    return std::nullopt;
}

std::optional<ViewGrid> views_in(const std::string& text)
{
    ViewGrid grid;
    int end = 0;
    if (std::sscanf(text.c_str(), "%4dx%4d%n", &grid.columns, &grid.rows, &end) != 2 ||
        end != int(text.size()) || grid.columns < 1 || grid.rows < 1 ||
        std::max(grid.columns, grid.rows) > most_views_of_quilt)
        return std::nullopt;
    return grid;
}

PanelQuilt quilt_for(const Panel& panel, const std::optional<ViewGrid>& tiles, QuiltSize size)
{
    const auto recommended = recommended_for(panel, tiles);
    return reduced(recommended ? *recommended
                               : quilt_of_tiles(panel, tiles.value_or(ViewGrid{8, 6})),
                   size == QuiltSize::draft  ? 4
                   : size == QuiltSize::good ? 2
                                             : 1);
}

} // namespace integral
