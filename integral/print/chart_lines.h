// SPDX-License-Identifier: AGPL-3.0-or-later
// Draws bars of lines for charts that measure lens sheets.
#ifndef INTEGRAL_PRINT_CHART_LINES_H
#define INTEGRAL_PRINT_CHART_LINES_H

#include "integral/frame/image.h"

#include <cmath>
#include <vector>

namespace integral {

/// A direction in which a sheet's lenses repeat.
struct ChartDirection {
    Vec2 wave;           ///< unit vector of the sheet frame (y upwards), perpendicular to the lines
    double period_share; ///< the lines' period divided by the lenses' pitch: 1; for hexagonal
                         ///< lenses 1/2 along the rows, and across them the row spacing, sqrt(3)/2
    bool upright;        ///< whether bars are upright: their lines are nearly horizontal
};

/// The directions in which a sheet's lenses repeat: one for lenticular sheets, two for 2-D sheets.
std::vector<ChartDirection> chart_directions(const LensSheet& sheet);

/// One bar: a rectangle of the page, in pixels, with light and dark lines, of equal width unless
/// `light_share` says otherwise. Light lines are `period` apart along `wave`. The middle of one
/// light line passes through `origin`, mm in the sheet frame. With `halves`, the lines of the bar's
/// second half (lower, or right if it is upright) pass through origin + wave period/4 instead.
struct ChartLines {
    double period; ///< mm
    Vec2 wave, origin;
    bool upright, halves = true;
    double light_share = 0.5; ///< width of a light line in periods; 0 to 1
    int left, top, width, height;
};

/// Sets the rectangle of a bar (with left, top, width and height) from its edges, mm from the
/// page's left and top edges, to whole pixels.
template <class Bar>
void set_rectangle(const Film& film, double left, double top, double right, double bottom, Bar& bar)
{
    const auto pixels = [](double mm, double pitch) { return int(std::lround(mm / pitch)); };
    bar.left = pixels(left, film.pixel_pitch.x);
    bar.top = pixels(top, film.pixel_pitch.y);
    bar.width = pixels(right, film.pixel_pitch.x) - bar.left;
    bar.height = pixels(bottom, film.pixel_pitch.y) - bar.top;
}

/// The greater of a pixel's width and height (mm), each projected onto the wave: lines whose period
/// is only a few times this length cannot be drawn.
double pixel_along(Vec2 wave, const Film& film);

/// The part of a pixel's area that light lines cover. `phase`: from the middle of a light line to
/// the pixel's middle, in periods. Projected along the lines, the pixel's area is the convolution
/// of two boxes; `a` and `b` are their half widths in periods, >= 0, at least one > 0. `share`: of
/// a light line in its period.
double line_coverage(double phase, double a, double b, double share = 0.5);

/// Draws a bar. The linear light of each pixel is exactly the part of its area that light lines
/// cover, so that no pitch is rounded to pixels.
void draw_lines(const Film& film, const ChartLines& bar, Image& image);

} // namespace integral

#endif
