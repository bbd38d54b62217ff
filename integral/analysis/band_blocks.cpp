// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/band_blocks.h"

#include "integral/analysis/photo_plane.h"
#include "integral/base/constants.h"
#include "integral/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

constexpr double guard = 0.5; ///< mm at a band's sides that are not measured

/// Mean light of the film's rectangle from `low` to `high` (mm); nothing if a part of it is outside
/// the photo.
std::optional<double> mean_light(const Plane& photo, const SheetView& view, Vec2 low, Vec2 high)
{
    const Vec2 a = photo_of_film(view, low), b = photo_of_film(view, {high.x, low.y}),
               c = photo_of_film(view, {low.x, high.y}), d = photo_of_film(view, high);
    for (const Vec2 corner : {a, b, c, d})
        if (!is_inside(photo, corner))
            return std::nullopt;
    const int columns = std::max(2, int(std::ceil(1.5 * length(b - a)))),
              rows = std::max(2, int(std::ceil(1.5 * length(c - a))));
    double sum = 0;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const double u = (i + 0.5) / columns, v = (j + 0.5) / rows;
            sum += value_at(photo, (1 - v) * ((1 - u) * a + u * b) + v * ((1 - u) * c + u * d));
        }
    return sum / (double(rows) * columns);
}

/// A block that is to be measured: of a band, from `begin` to `end` mm along it, in `cells` cells
/// along it and `rows` across it.
struct BlockPlan {
    int band, column, cells, rows;
    double begin, end;
};

std::vector<BlockPlan> plans_of(const CalibrationPage& page, const CalibrationLayout& layout)
{
    constexpr double row = 0.75, tint_guard = 1.5; // mm
    std::vector<BlockPlan> plans;
    for (int index = 0; index < int(layout.bands.size()); ++index) {
        const CalibrationBand& band = layout.bands[index];
        const Vec2 pixel = page.film.pixel_pitch;
        const double whole = band.upright ? band.height * pixel.y : band.width * pixel.x,
                     thick = band.upright ? band.width * pixel.x : band.height * pixel.y;
        if (band.kind == BandKind::tint) {
            plans.push_back({index, 0, 1, 1, tint_guard, whole - tint_guard});
            continue;
        }
        const bool coarse = band.kind == BandKind::coarse;
        const double cell = coarse ? band.period / 12 : std::max(2.5, 2 * page.sheet.pitch);
        const int cells = coarse ? 24 : 4, rows = coarse ? 1 : int((thick - 2 * guard) / row),
                  count = std::max(1, int(whole / (cell * cells)));
        const double step = coarse ? cell * cells : whole / count; // coarse: whole periods
        for (int k = 0; k < count; ++k)
            plans.push_back({index, k, cells, rows, k * step, (k + 1) * step});
    }
    return plans;
}

std::optional<BandBlock> measured(const Plane& photo, const CalibrationPage& page,
                                  const CalibrationLayout& layout, const SheetView& view,
                                  const BlockPlan& plan)
{
    const CalibrationBand& band = layout.bands[plan.band];
    const Vec2 pixel = page.film.pixel_pitch;
    // The band's corner from which `begin` is measured, and its thickness.
    const Vec2 origin = film_from_pixel(page.film, {double(band.left), double(band.top)});
    const double thick = band.upright ? band.width * pixel.x : band.height * pixel.y,
                 along = (plan.end - plan.begin) / plan.cells,
                 across = (thick - 2 * guard) / plan.rows;
    BandBlock block{band.kind, band.group, plan.column, {}, {}};
    for (int j = 0; j < plan.rows; ++j)
        for (int i = 0; i < plan.cells; ++i) {
            const double a = plan.begin + i * along, b = guard + j * across;
            const Vec2 low = band.upright ? Vec2{origin.x + b, origin.y - a - along}
                                          : Vec2{origin.x + a, origin.y - b - across},
                       high = low + (band.upright ? Vec2{across, along} : Vec2{along, across});
            const auto light = mean_light(photo, view, low, high);
            if (!light)
                return std::nullopt;
            const double place = plan.rows > 1 ? (j + 0.5) / plan.rows : (i + 0.5) / plan.cells,
                         window = std::sin(pi * place);
            block.cells.push_back(
                {plan.band, photo_of_film(view, 0.5 * (low + high)), *light, window * window});
        }
    const double a = 0.5 * (plan.begin + plan.end), b = 0.5 * thick;
    block.photo = photo_of_film(view, origin + (band.upright ? Vec2{b, -a} : Vec2{a, -b}));
    return block;
}

} // namespace

std::vector<BandBlock> measure_blocks(const Plane& photo, const CalibrationPage& page,
                                      const CalibrationLayout& layout, const SheetView& view,
                                      int threads)
{
    const std::vector<BlockPlan> plans = plans_of(page, layout);
    std::vector<std::optional<BandBlock>> all(plans.size());
    for_each_row(int(plans.size()), threads,
                 [&](int k) { all[k] = measured(photo, page, layout, view, plans[k]); });
    std::vector<BandBlock> blocks;
    for (auto& block : all)
        if (block)
            blocks.push_back(std::move(*block));
    return blocks;
}

} // namespace integral
