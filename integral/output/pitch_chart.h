// SPDX-License-Identifier: AGPL-3.0-or-later
// A chart by which a lens sheet's pitch is measured: bars of lines, each bar with another pitch,
// that are laid under the sheet.
//
// To an eye at distance D, one bar looks even through the lenses: the bar whose pitch is the visual
// pitch p (1 + t/(nD)), at which the lenses image the film, and not their own pitch p. Here a bar's
// pitch is therefore called its film pitch; pitch_wizard.h computes p from it.
#ifndef INTEGRAL_OUTPUT_PITCH_CHART_H
#define INTEGRAL_OUTPUT_PITCH_CHART_H

#include "integral/lightfield/image.h"
#include "integral/output/pitch_wizard.h"

namespace integral {

struct PitchChart {
    LensSheet sheet; ///< the nominal sheet; its offset is not used
    Film film;       ///< the whole page
    PitchScale scale;
    /// Viewing distances, mm, for each of which the page says which bar is even; those of less than
    /// twice a bar's length are left out.
    std::vector<double> distances = {250, 400, 600, 1000, 2000};
    std::string note; ///< the page's last line, such as the command that takes the readings
    /// The name of the panel, if the chart is a card that a panel shows under its own lenses; empty
    /// for a page of paper.
    std::string panel;
};

/// One bar: a rectangle of the page, in pixels, with light and dark lines of equal width. The lines
/// are perpendicular to `wave`, a unit vector of the sheet frame (y upwards), and light lines are
/// `period` apart. In the bar's first half (the upper half; of an upright bar the left one) the
/// middle of a light line passes through `origin`, mm in the sheet frame; in the second half it
/// passes through origin + wave period/4.
struct ChartBar {
    /// As printed, from 1. The bars of a 2-D sheet's second direction follow those of the first.
    int number;
    double pitch; ///< mm: lenses of this visual pitch show the bar even
    /// mm: the pitch; for hexagonal lenses p/2 along the rows, and across them p sqrt(3)/2, the
    /// distance of the rows.
    double period;
    Vec2 wave, origin;
    bool upright; ///< whether the bar's longer side is vertical: its lines are nearly horizontal
    int left, top, width, height;
};

/// The bars with their places: of one direction for lenticular sheets, of two for the others.
/// Throws std::invalid_argument, saying what would help, where the page is too small for the bars,
/// or where a period has less than 2 pixels.
std::vector<ChartBar> chart_bars(const PitchChart& chart);

/// What the page says at its head: how it is looked at, and on paper how it is printed and laid
/// under the lenses.
std::string chart_advice(const PitchChart& chart);

/// The page, 8 bits a channel, sRGB, film.width x film.height pixels. The linear light of a bar's
/// pixel is exactly the part of its area that light lines cover, so that no pitch is rounded to
/// pixels. Throws as chart_bars does.
Image pitch_chart(const PitchChart& chart);

/// The part of a pixel's area that light lines cover. `phase`: from the middle of a light line to
/// the pixel's middle, periods. Projected along the lines, the pixel's area is the convolution of
/// two boxes; `a` and `b` are their half widths in periods, >= 0, one of them > 0.
double line_coverage(double phase, double a, double b);

} // namespace integral

#endif
