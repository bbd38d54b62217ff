// SPDX-License-Identifier: AGPL-3.0-or-later
// A chart that tells a lens sheet's pitch: bars of lines, each of a pitch of its own, that are laid
// under the sheet.
//
// An eye at distance D sees a bar even whose pitch is that at which the lenses show it the film:
// the visual pitch p (1 + t/(nD)), not the lenses' own p. So a bar's pitch is called its film pitch
// here; pitch_wizard.h goes on from it.
#ifndef INTEGRAL_OUTPUT_PITCH_CHART_H
#define INTEGRAL_OUTPUT_PITCH_CHART_H

#include "integral/lightfield/image.h"
#include "integral/output/pitch_wizard.h"

namespace integral {

struct PitchChart {
    LensSheet sheet; ///< as it is thought to be; its offset counts for nothing
    Film film;       ///< of the whole page
    PitchScale scale;
    std::vector<double> distances = {250, 400, 600, 1000, 2000}; ///< mm: the page says which bar is
                                                                 ///< even from those that are at
                                                                 ///< least twice a bar's length
    std::string note;  ///< a last line, such as the command that takes the readings
    std::string panel; ///< of a card that a panel shows under its own lenses: the panel's name;
                       ///< else empty, and the page is for paper
};

/// One bar: a rectangle of the page in pixels, of lines as light as dark. Its lines are
/// perpendicular to `wave`, a unit vector of the sheet frame (y upwards), and `period` apart; in
/// its first half (the upper; of an upright bar the left) a light line's middle passes through
/// `origin`, mm in the sheet frame, in the second half through origin + wave period/4.
struct ChartBar {
    int number; ///< as printed; from 1. The bars of a 2-D sheet's second direction follow those of
                ///< the first.
    double pitch;  ///< mm: lenses of this visual pitch show it even
    double period; ///< mm: the pitch, but of hexagonal lenses p/2 along the rows and p sqrt(3)/2,
                   ///< the rows' distance, across them
    Vec2 wave, origin;
    bool upright; ///< the bar's longer side is vertical, as its lines are rather horizontal
    int left, top, width, height;
};

/// Where the bars are: one direction's for lenticular sheets, two for the others. Throws
/// std::invalid_argument, naming what would help, where a page is too small for its bars or pixels
/// are too coarse for the lines (less than 2 a period).
std::vector<ChartBar> chart_bars(const PitchChart& chart);

/// What the page says at its head: how it is looked at, and on paper how it is printed and laid
/// under the lenses.
std::string chart_advice(const PitchChart& chart);

/// The page, 8 bits a channel, sRGB, film.width x film.height: each pixel of a bar holds how much
/// of its area light lines cover, exactly, in linear light, so that no pitch is rounded to pixels.
/// Throws as chart_bars does.
Image pitch_chart(const PitchChart& chart);

/// How much of a pixel light lines cover: of a pixel at `phase` (periods from the middle of a light
/// line) that, seen along the lines, is two boxes of half widths `a` and `b` periods (>= 0, one >
/// 0) convolved.
double line_coverage(double phase, double a, double b);

} // namespace integral

#endif
