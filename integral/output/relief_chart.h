// SPDX-License-Identifier: AGPL-3.0-or-later
// A chart by which printed lenses are brought into register with the picture below them: the
// picture is printed first, and the lenses over it.
//
// Lenses at pole P, seen from an eye at distance D above the page's middle, show the film at
// P (1 + t/(nD)). So lines p (1 + t/(nD)) apart look evenly light or dark under them: how light
// tells the lenses' place, and lines that are slightly closer or wider apart are even under lenses
// of another pitch. A chart has bars of both kinds for each direction of the lenses.
#ifndef INTEGRAL_OUTPUT_RELIEF_CHART_H
#define INTEGRAL_OUTPUT_RELIEF_CHART_H

#include "integral/output/chart_lines.h"

#include <string>

namespace integral {

struct ReliefChart {
    LensSheet sheet;       ///< the lenses that are to be printed
    Film film;             ///< the page
    double distance = 400; ///< mm from the eye to the lenses
};

struct ReliefBar : ChartLines {
    /// Of a pitch bar: the pitch of the lenses under which it is even, divided by the nominal one,
    /// less 1. Of a phase bar: 0.
    double stretch = 0;
    /// Of a phase bar: how far (mm) the lenses under which it is lightest are off their place.
    Vec2 offset;
    std::string label;
};

/// The bars of each direction: the pitch bars, then the phase bars. Throws std::invalid_argument,
/// saying what would help, where the page has no room for them, or the film too large pixels.
std::vector<ReliefBar> relief_bars(const ReliefChart& chart);

/// The picture: 8 bits a channel, sRGB. Throws as relief_bars does.
Image relief_chart(const ReliefChart& chart);

/// Sets the pixels of a height map that are not over a bar to `ground` (0 to 1), so that labels can
/// be read. It has the chart's film.
void flatten_beside(const std::vector<ReliefBar>& bars, float ground, Image& relief);

} // namespace integral

#endif
