// SPDX-License-Identifier: AGPL-3.0-or-later
// Draws a chart for measuring a lens sheet's pitch: bars of lines, each with another pitch, to be
// laid under the sheet.
//
// To an eye at distance D, one bar looks even through the lenses, without light and dark bands. Its
// pitch is the visual pitch p (1 + t/(nD)), at which lenses of pitch p image the film. A bar's
// pitch is therefore called its film pitch here; pitch_wizard.h computes p from the film pitch.
#ifndef INTEGRAL_PRINT_PITCH_CHART_H
#define INTEGRAL_PRINT_PITCH_CHART_H

#include "integral/print/chart_lines.h"
#include "integral/print/pitch_wizard.h"

namespace integral {

struct PitchChart {
    LensSheet sheet; ///< the nominal sheet; its offset is not used
    Film film;       ///< the whole page
    PitchScale scale;
    /// Viewing distances, mm, for which the page names the bar that looks even; distances less than
    /// twice a bar's length are left out.
    std::vector<double> distances = {250, 400, 600, 1000, 2000};
    std::string note; ///< the page's last line, such as the command that takes the readings
    /// The name of the panel, if the chart is a card that a panel shows under its own lenses; empty
    /// for a page of paper.
    std::string panel;
};

/// One bar. All bars of a direction have the same phase in the middle of their block.
struct ChartBar : ChartLines {
    /// Number as printed, from 1. A 2-D sheet's second direction continues the first one's numbers.
    int number;
    double pitch; ///< mm: under lenses of this visual pitch the bar looks even
};

/// The bars with their places: one direction for lenticular sheets, two for 2-D sheets. Throws
/// std::invalid_argument, with advice, if the page is too small for the bars, or if a period has
/// less than 2 pixels.
std::vector<ChartBar> chart_bars(const PitchChart& chart);

/// Text at the page's head: how to look at it, and on paper how to print it and lay it under the
/// lenses.
std::string chart_advice(const PitchChart& chart);

/// The page, 8 bits a channel, sRGB, film.width x film.height pixels. Throws as chart_bars does.
Image pitch_chart(const PitchChart& chart);

} // namespace integral

#endif
