// SPDX-License-Identifier: AGPL-3.0-or-later
// Maps pixels of parallel views to places on the film and back, for taking a frame apart into views
// and for making a frame from views.
#ifndef INTEGRAL_VIEWS_VIEW_LENSES_H
#define INTEGRAL_VIEWS_VIEW_LENSES_H

#include "integral/frame/frame.h"
#include "integral/frame/view_grid.h"
#include "integral/optics/lens_mapping.h"
#include "integral/replay/interpolate.h"
#include "integral/views/parallel_views.h"

#include <optional>

namespace integral {

/// The pixels along one side of a film whose lenses are a whole number of pixels wide: each pixel
/// has a lens and a place in it. A pixel on the border of two lenses belongs to the second one.
struct Side {
    int pixels; ///< to a lens
    int border; ///< the first pixel of the second lens
    int lens(int pixel) const { return pixel < border ? 0 : (pixel - border) / pixels + 1; }
    int place(int pixel) const
    {
        return pixel < border ? pixel - border + pixels : (pixel - border) % pixels;
    }
};

/// The side of a film along lenticular lenses: each pixel counts as a lens.
constexpr Side each_pixel{1, 1};

/// The lenses of a frame, and the place in each lens that a view shows. A view of upright
/// lenticular lenses has a column for each lens and the film's rows; a view of lenticular lenses
/// that lie across has a row for each lens and the film's columns.
class Lenses {
public:
    /// Throws as lens_window does.
    Lenses(const FrameMetadata& metadata, ViewGrid grid);

    Vec2 point(int x, int y) const { return film_from_pixel(film, {x + 0.5, y + 0.5}); }

    /// The lens of a view's pixel. The inverses, column_of and row_of, give the first pixel of the
    /// lens in front of the film pixel at column `film_column` and row `film_row`.
    LensIndex lens_at(int column, int view_row) const
    {
        if (lie_across)
            return {window.first.i - upwards * view_row, 0};
        if (arrangement == Arrangement::lenticular)
            return {window.first.i + column, 0};
        const std::int64_t j = window.first.j - view_row;
        if (arrangement == Arrangement::square)
            return {window.first.i + column, j};
        const int shifted = column - int(j & 1);
        return {window.first.i + (shifted < 0 ? -1 : shifted / 2), j};
    }
    int column_of(LensIndex lens, int film_column) const
    {
        if (lie_across)
            return film_column;
        const int i = int(lens.i - window.first.i);
        return arrangement == Arrangement::hexagonal ? 2 * i + int(lens.j & 1) : i;
    }
    int row_of(LensIndex lens, int film_row) const
    {
        if (lie_across)
            return upwards * int(window.first.i - lens.i);
        return arrangement == Arrangement::lenticular ? film_row : int(window.first.j - lens.j);
    }

    /// The middle of a lens; for a lenticular lens, the point where its axis crosses row `film_row`
    /// of the film or, if the lenses lie across, column `film_column`.
    Vec2 middle(LensIndex lens, int film_column, int film_row) const
    {
        const Vec2 pole = lattice.pole(lens);
        if (arrangement != Arrangement::lenticular)
            return pole;
        const Vec2 along = lattice.along(), at = point(film_column, film_row);
        if (lie_across)
            return {at.x, pole.y + (at.x - pole.x) / along.x * along.y};
        return {pole.x + (at.y - pole.y) / along.y * along.x, at.y};
    }
    /// The film point that is `part` (in a lens's widths and heights) away from its middle; part_of
    /// is the inverse.
    Vec2 film_point(Vec2 middle, Vec2 part) const
    {
        if (lie_across)
            return {middle.x, middle.y + part.y * breadth};
        if (arrangement == Arrangement::lenticular)
            return {middle.x + part.x * breadth, middle.y};
        return middle + (part.x * breadth) * lattice.across() + (part.y * row) * lattice.along();
    }
    /// The place in every lens that view number k shows.
    Vec2 part_of_view(int k) const
    {
        return {0.5 - (k % grid.columns + 0.5) / grid.columns,
                0.5 - (k / grid.columns + 0.5) / grid.rows};
    }
    Vec2 part_of(Vec2 middle, Vec2 film_point) const
    {
        const Vec2 off = film_point - middle;
        if (lie_across)
            return {0, off.y / breadth};
        if (arrangement == Arrangement::lenticular)
            return {off.x / breadth, 0};
        return {dot(off, lattice.across()) / breadth, dot(off, lattice.along()) / row};
    }

    Film film;
    Lattice lattice;
    ViewGrid grid;
    Arrangement arrangement;
    bool lie_across;            ///< lenses_lie_across
    int upwards;                ///< lenses that lie across: 1 if their numbers grow upwards, else
                                ///< -1
    double pitch, row, breadth; ///< breadth: of a lens along the film's rows, or its columns
    bool exact;
    Side across{}, down{};
    LensWindow window;

private:
    /// The lenses over the film's border, and so over all of it. `corner`: the lens over the first
    /// film pixel. Throws std::invalid_argument if there are too many lenses.
    LensWindow window_of_border(LensIndex corner) const;
};

/// The light of one pixel of a view, interpolated on the film (if views_are_exact is false);
/// nothing where there is no film behind the lens.
inline std::optional<Colour> view_pixel(const Lenses& lenses, const LinearReader& light, int view,
                                        int column, int row)
{
    const Film& film = lenses.film;
    const Vec2 middle = lenses.middle(lenses.lens_at(column, row), column, row);
    const Vec2 at = pixel_from_film(film, lenses.film_point(middle, lenses.part_of_view(view)));
    if (!(at.x >= 0 && at.y >= 0 && at.x < film.width && at.y < film.height))
        return std::nullopt;
    return each_channel(film.subpixels,
                        [&](int channel) { return of_subpixels(light, film, at, channel); });
}

/// Where a channel of a film pixel comes from: pixel (column, row) of every view, and place (x, y)
/// among the views, in columns and rows of the ViewGrid; whole numbers are the views themselves.
struct ViewPlace {
    int column, row;
    double x, y;
};

inline ViewPlace view_place(const Lenses& lenses, int x, int y, int channel)
{
    const Film& film = lenses.film;
    const Vec2 point = film_from_pixel(film, subpixel_centre(film.subpixels, x, y, channel));
    const LensIndex lens = lenses.lattice.nearest(point);
    const Vec2 part = lenses.part_of(lenses.middle(lens, x, y), point);
    return {std::clamp(lenses.column_of(lens, x), 0, lenses.window.columns - 1),
            std::clamp(lenses.row_of(lens, y), 0, lenses.window.rows - 1),
            (0.5 - part.x) * lenses.grid.columns - 0.5, (0.5 - part.y) * lenses.grid.rows - 0.5};
}

/// The light of a film pixel, interpolated between the directions of the views around its ray.
/// at(view, column, row) gives the light of a view's pixel as a Colour.
template <class At> Colour film_pixel(const Lenses& lenses, int x, int y, At at)
{
    const ViewGrid grid = lenses.grid;
    return each_channel(lenses.film.subpixels, [&](int channel) {
        const ViewPlace place = view_place(lenses, x, y, channel);
        return between(place.x, place.y, grid.columns, grid.rows, [&](int i, int j) {
            return at(j * grid.columns + i, place.column, place.row);
        });
    });
}

} // namespace integral

#endif
