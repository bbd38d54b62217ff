// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/replay/view_lenses.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace integral {
namespace {

constexpr double whole = 1e-6; // pixels by which a whole number may be off

bool is_whole(double value) { return std::fabs(value - std::round(value)) < whole; }

/// Pixels to a lens along the film's rows and columns (lenticular: the second is 0).
Vec2 pixels_a_lens(const FrameMetadata& m)
{
    const Lattice lattice(m.sheet);
    const double p = m.sheet.pitch;
    if (m.sheet.arrangement == Arrangement::lenticular)
        return {p / std::fabs(lattice.across().x) / m.film.pixel_pitch.x, 0};
    return {p / m.film.pixel_pitch.x, lattice.row_spacing() / m.film.pixel_pitch.y};
}

/// `first` is the distance (mm) of the first pixel's centre from the first lens's pole, in the
/// direction in which pixels are counted.
Side side_of(double first, double pixel_pitch, double pitch)
{
    return {int(std::lround(pitch / pixel_pitch)),
            int(std::ceil((0.5 * pitch - first) / pixel_pitch - whole))};
}

} // namespace

Lenses::Lenses(const FrameMetadata& m, ViewGrid grid)
    : film(m.film),
      lattice(m.sheet),
      grid(grid),
      arrangement(m.sheet.arrangement),
      pitch(m.sheet.pitch),
      exact(views_are_exact(m, grid))
{
    const bool lenticular = arrangement == Arrangement::lenticular;
    if (lenticular && !slit_is_horizontal(m.sheet))
        throw std::invalid_argument("the lenses lie across (slant beyond 45 degrees): there are no "
                                    "views from left to right");
    row = lattice.row_spacing();
    breadth = lenticular ? pitch / lattice.across().x : pitch;
    const LensIndex corner = lattice.nearest(point(0, 0));
    if (exact) {
        const Vec2 first = point(0, 0), pole = lattice.pole(corner);
        across = side_of(first.x - pole.x, film.pixel_pitch.x, pitch);
        window = {corner, across.lens(film.width - 1) + 1, film.height};
        if (!lenticular) {
            down = side_of(pole.y - first.y, film.pixel_pitch.y, pitch);
            window.rows = down.lens(film.height - 1) + 1;
        }
        return;
    }
    window = window_of_border(corner);
}

LensWindow Lenses::window_of_border(LensIndex corner) const
{
    LensIndex least = corner, most = corner;
    const auto take = [&](int x, int y) {
        const LensIndex lens = lattice.nearest(point(x, y));
        least = {std::min(least.i, lens.i), std::min(least.j, lens.j)};
        most = {std::max(most.i, lens.i), std::max(most.j, lens.j)};
    };
    for (int x = 0; x < film.width; ++x)
        for (const int y : {0, film.height - 1})
            take(x, y);
    for (int y = 0; y < film.height; ++y)
        for (const int x : {0, film.width - 1})
            take(x, y);
    constexpr std::int64_t most_lenses = 1000000;
    if (most.i - least.i >= most_lenses || most.j - least.j >= most_lenses)
        throw std::invalid_argument("its film lies behind more than 1000000 lenses one way: they "
                                    "are much narrower than its pixels");
    const int lenses = int(most.i - least.i + 1);
    return {{least.i, most.j},
            arrangement == Arrangement::hexagonal ? 2 * lenses + 1 : lenses,
            arrangement == Arrangement::lenticular ? film.height : int(most.j - least.j + 1)};
}

ViewGrid natural_views(const FrameMetadata& m)
{
    const Vec2 pixels = pixels_a_lens(m);
    const auto count = [](double v) { return int(std::lround(std::clamp(v, 1.0, 1e9))); };
    return {count(pixels.x), count(pixels.y)};
}

bool views_are_exact(const FrameMetadata& m, ViewGrid grid)
{
    const Vec2 pixels = pixels_a_lens(m);
    const bool lenticular = m.sheet.arrangement == Arrangement::lenticular; // pixels.y is 0
    const bool some = pixels.x > 0.5 && (lenticular || pixels.y > 0.5);     // 0 is whole, too
    return some && m.sheet.arrangement != Arrangement::hexagonal && m.sheet.slant == 0 &&
           m.film.subpixels == Subpixels::none && is_whole(pixels.x) && is_whole(pixels.y) &&
           grid.columns == natural_views(m).columns && grid.rows == natural_views(m).rows;
}

LensWindow lens_window(const FrameMetadata& metadata)
{
    return Lenses(metadata, natural_views(metadata)).window;
}

} // namespace integral
