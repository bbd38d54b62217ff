// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/views/view_lenses.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace integral {
namespace {

constexpr double whole = 1e-6; // pixels by which a whole number may be inexact

bool is_whole(double value) { return std::fabs(value - std::round(value)) < whole; }

/// The same lenses with the least slant: square ones look the same after a quarter of a turn,
/// hexagonal ones after a sixth.
LensSheet least_slanted(LensSheet sheet)
{
    if (sheet.arrangement != Arrangement::lenticular)
        sheet.slant = std::remainder(sheet.slant,
                                     sheet.arrangement == Arrangement::square ? 90 : 60);
    return sheet;
}

/// Pixels to a lens along the film's rows, and along its columns (along lenticular lenses: 0).
Vec2 pixels_a_lens(const FrameMetadata& m)
{
    const Lattice lattice(m.sheet);
    const double p = m.sheet.pitch;
    if (lenses_lie_across(m.sheet))
        return {0, p / std::fabs(lattice.across().y) / m.film.pixel_pitch.y};
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
      lattice(least_slanted(m.sheet)),
      grid(grid),
      arrangement(m.sheet.arrangement),
      lie_across(lenses_lie_across(m.sheet)),
      upwards(lattice.across().y < 0 ? -1 : 1),
      pitch(m.sheet.pitch),
      exact(views_are_exact(m, grid))
{
    const bool lenticular = arrangement == Arrangement::lenticular;
    row = lattice.row_spacing();
    breadth = !lenticular  ? pitch
              : lie_across ? pitch / std::fabs(lattice.across().y)
                           : pitch / lattice.across().x;
    const LensIndex corner = lattice.nearest(point(0, 0));
    if (exact) {
        const Vec2 first = point(0, 0), pole = lattice.pole(corner);
        across = lie_across ? each_pixel : side_of(first.x - pole.x, film.pixel_pitch.x, pitch);
        down = lenticular && !lie_across ? each_pixel
                                         : side_of(pole.y - first.y, film.pixel_pitch.y, pitch);
        window = {corner, across.lens(film.width - 1) + 1, down.lens(film.height - 1) + 1};
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
    if (lie_across)
        return {{upwards > 0 ? most.i : least.i, 0}, film.width, lenses};
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
    const bool lenticular = m.sheet.arrangement == Arrangement::lenticular; // one number is 0
    const bool some = lenticular ? std::max(pixels.x, pixels.y) > 0.5
                                 : std::min(pixels.x, pixels.y) > 0.5; // as 0 is whole, too
    return some && m.sheet.arrangement != Arrangement::hexagonal &&
           std::remainder(m.sheet.slant, 90) == 0 && m.film.subpixels == Subpixels::none &&
           is_whole(pixels.x) && is_whole(pixels.y) && grid.columns == natural_views(m).columns &&
           grid.rows == natural_views(m).rows;
}

LensWindow lens_window(const FrameMetadata& metadata)
{
    return Lenses(metadata, natural_views(metadata)).window;
}

} // namespace integral
