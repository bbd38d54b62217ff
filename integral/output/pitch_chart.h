// SPDX-License-Identifier: AGPL-3.0-or-later
// A chart by which a lens sheet's pitch is measured: bars of lines, each bar with another pitch,
// that are laid under the sheet.
//
// To an eye at distance D, one bar looks even through the lenses: the bar whose pitch is the visual
// pitch p (1 + t/(nD)), at which the lenses image the film, and not their own pitch p. Here a bar's
// pitch is therefore called its film pitch; pitch_wizard.h computes p from it.
#ifndef INTEGRAL_OUTPUT_PITCH_CHART_H
#define INTEGRAL_OUTPUT_PITCH_CHART_H

#include "integral/output/chart_lines.h"
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

/// One bar. All of a direction have their phase in common in the middle of their block.
struct ChartBar : ChartLines {
    /// As printed, from 1. The bars of a 2-D sheet's second direction follow those of the first.
    int number;
    double pitch; ///< mm: lenses of this visual pitch show the bar even
};

/// The bars with their places: of one direction for lenticular sheets, of two for the others.
/// Throws std::invalid_argument, saying what would help, where the page is too small for the bars,
/// or where a period has less than 2 pixels.
std::vector<ChartBar> chart_bars(const PitchChart& chart);

/// What the page says at its head: how it is looked at, and on paper how it is printed and laid
/// under the lenses.
std::string chart_advice(const PitchChart& chart);

/// The page, 8 bits a channel, sRGB, film.width x film.height pixels. Throws as
/// chart_bars does.
Image pitch_chart(const PitchChart& chart);

} // namespace integral

#endif
