// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/wireframe/lens_pixels.h"

#include "integral/base/parallel.h"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace integral {
namespace {

std::vector<LensRun> runs_of_row(const SheetOptics& optics, const Film& film, LensMapping mapping,
                                 Vec2 shift, int row)
{
    std::vector<LensRun> runs;
    RayRun<Vec2> points;
    RayRun<MappedPoint> mapped;
    for (int x = 0; x < film.width; x += run_length) {
        for (int k = 0; k < run_length; ++k)
            points[k] = film_from_pixel(
                film, Vec2{std::min(x + k, film.width - 1) + 0.5, row + 0.5} + shift);
        optics.map_run(run_length, points, mapping, mapped);
        for (int k = 0; k < run_length && x + k < film.width; ++k) {
            if (!mapped[k].ray)
                continue;
            const LensIndex lens = mapped[k].ray->lens;
            if (!runs.empty() && runs.back().end == x + k && runs.back().lens == lens)
                ++runs.back().end;
            else
                runs.push_back({lens, row, x + k, x + k + 1});
        }
    }
    return runs;
}

} // namespace

LensPixels::LensPixels(const SheetOptics& optics, const Film& film, LensMapping mapping, Vec2 shift,
                       int threads)
{
    std::vector<std::vector<LensRun>> rows(std::size_t(film.height));
    for_each_row(film.height, threads, [&](int row) {
        rows[std::size_t(row)] = runs_of_row(optics, film, mapping, shift, row);
    });
    for (auto& row : rows)
        std::move(row.begin(), row.end(), std::back_inserter(runs_));
    const auto key = [](const LensRun& r) {
        return std::tuple(r.lens.j, r.lens.i, r.row, r.first);
    };
    std::sort(runs_.begin(), runs_.end(),
              [&](const LensRun& a, const LensRun& b) { return key(a) < key(b); });
    for (std::size_t k = 0; k < runs_.size(); ++k)
        if (k == 0 || runs_[k].lens != runs_[k - 1].lens)
            first_run_.push_back(k);
    first_run_.push_back(runs_.size());
}

} // namespace integral
