// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/lens_borders.h"

#include "integral/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

/// The lens of a film point; nothing if the point is dark.
using Owner = std::optional<LensIndex>;

class Borders {
public:
    Borders(const SheetOptics& optics, LensMapping mapping) : optics_(optics), mapping_(mapping) {}

    Owner owner(Vec2 point) const
    {
        const auto mapped = optics_.map(point, mapping_);
        return mapped.ray ? Owner(mapped.ray->lens) : std::nullopt;
    }

    /// Adds the borders along a line of `count` points from `start`: exact places if `exactly`,
    /// else the middles between two points.
    void along(Vec2 start, Vec2 step, int count, bool exactly, std::vector<Vec2>& found) const
    {
        Owner before = owner(start);
        for (int k = 1; k < count; ++k) {
            const Vec2 to = start + double(k) * step;
            const Owner here = owner(to);
            if (here != before) {
                const Vec2 from = to - step;
                const double at = exactly ? 0.5 * (last_of(from, step, before) + 1 -
                                                   last_of(to, -1.0 * step, here))
                                          : 0.5;
                found.push_back(from + at * step);
            }
            before = here;
        }
    }

private:
    /// Fraction of `step` up to which the owner of `from` stays the same, if it changes once.
    double last_of(Vec2 from, Vec2 step, const Owner& same) const
    {
        double inside = 0, outside = 1;
        for (int k = 0; k < 10; ++k) {
            const double middle = 0.5 * (inside + outside);
            (owner(from + middle * step) == same ? inside : outside) = middle;
        }
        return 0.5 * (inside + outside);
    }

    const SheetOptics& optics_;
    LensMapping mapping_;
};

/// Whether the rows and the columns of a raster cross borders at steep angles.
struct Crossing {
    explicit Crossing(const LensSheet& sheet)
        : lenticular(sheet.arrangement == Arrangement::lenticular),
          rows(!lenticular || slit_is_horizontal(sheet)),
          columns(!lenticular || !rows)
    {
    }
    bool lenticular, rows, columns;

    /// Calls sweep(of_rows) for lines along rows, and for lines along columns, if they cross
    /// borders.
    template <class Sweep> void for_each(Sweep sweep) const
    {
        if (rows)
            sweep(true);
        if (columns)
            sweep(false);
    }
};

/// Adds the borders that `count` lines cross, as found by trace(line, points).
template <class Trace> void trace_lines(int count, int threads, Trace trace, std::vector<Vec2>& all)
{
    std::vector<std::vector<Vec2>> found(count);
    for_each_row(count, threads, [&](int line) { trace(line, found[line]); });
    for (const auto& line : found)
        all.insert(all.end(), line.begin(), line.end());
}

/// Spacing (mm) of lines that cross borders about `most` times; from `step` to four pitches.
double line_spacing(const LensSheet& sheet, Vec2 half, double step, int most)
{
    const double crossings = 4 * half.x * half.y / sheet.pitch *
                             (sheet.arrangement == Arrangement::lenticular ? 1 : 2);
    return std::clamp(crossings / most, step, std::max(step, 4 * sheet.pitch));
}

} // namespace

std::vector<Vec2> lens_borders(const SheetOptics& optics, LensMapping mapping, Vec2 half,
                               double step, int most, int threads)
{
    const Crossing crossing(optics.sheet());
    const double spacing = line_spacing(optics.sheet(), half, step, most);
    const Borders borders(optics, mapping);
    std::vector<Vec2> all;
    crossing.for_each([&](bool of_rows) {
        const double length = of_rows ? half.x : half.y, breadth = of_rows ? half.y : half.x;
        const int lines = std::max(1, int(2 * breadth / spacing)),
                  count = std::max(2, int(2 * length / step));
        trace_lines(
            lines, threads,
            [&](int line, std::vector<Vec2>& found) {
                const double at = -breadth + (line + 0.5) * (2 * breadth / lines),
                             first = -length + 0.5 * step;
                borders.along(of_rows ? Vec2{first, at} : Vec2{at, first},
                              of_rows ? Vec2{step, 0} : Vec2{0, step}, count, true, found);
            },
            all);
    });
    return all;
}

std::vector<Vec2> lens_borders_of_pixels(const SheetOptics& optics, LensMapping mapping,
                                         const Film& film, int most, int threads)
{
    Crossing crossing(optics.sheet());
    if (optics.sheet().slant != 0)
        crossing.rows = crossing.columns = true; // slanted borders have steps both ways
    const Vec2 pitch = film.pixel_pitch;
    const double spacing = line_spacing(optics.sheet(),
                                        {0.5 * film.width * pitch.x, 0.5 * film.height * pitch.y},
                                        std::max(pitch.x, pitch.y), most);
    const Borders borders(optics, mapping);
    std::vector<Vec2> all;
    crossing.for_each([&](bool of_rows) {
        const int apart = std::max(1, int(spacing / (of_rows ? pitch.y : pitch.x)));
        const int lines = std::max(1, (of_rows ? film.height : film.width) / apart);
        trace_lines(
            lines, threads,
            [&](int line, std::vector<Vec2>& found) {
                const double at = line * apart + 0.5;
                borders.along(film_from_pixel(film, of_rows ? Vec2{0.5, at} : Vec2{at, 0.5}),
                              of_rows ? Vec2{pitch.x, 0} : Vec2{0, -pitch.y},
                              of_rows ? film.width : film.height, false, found);
            },
            all);
    });
    return all;
}

} // namespace integral
