// SPDX-License-Identifier: AGPL-3.0-or-later
// Draws a chart to bring printed lenses into register with the picture below them: the picture is
// printed first, and the lenses over it.
//
// A lens with pole P shows an eye at distance D above the page's middle the film at P (1 + t/(nD)).
// So lines p (1 + t/(nD)) apart look evenly light or dark under the lenses, and how light they look
// depends on the lenses' place (phase bars). Lines slightly closer or wider apart look even under
// lenses of another pitch (pitch bars). A chart has both kinds for each direction of the lenses.
#ifndef INTEGRAL_PRINT_RELIEF_CHART_H
#define INTEGRAL_PRINT_RELIEF_CHART_H

#include "integral/print/chart_lines.h"

#include <string>

namespace integral {

struct ReliefChart {
    LensSheet sheet;       ///< the lenses to print
    Film film;             ///< the page
    double distance = 400; ///< mm from the eye to the lenses
};

struct ReliefBar : ChartLines {
    /// Pitch bars: pitch of the lenses under which the bar looks even, divided by the nominal
    /// pitch, less 1. Phase bars: 0.
    double stretch = 0;
    /// Phase bars: displacement (mm) of the lenses under which the bar is lightest.
    Vec2 offset;
    std::string label;
};

/// The bars of each direction: the pitch bars, then the phase bars. Throws std::invalid_argument,
/// with advice, if the page has no room for them, or if the film's pixels are too large.
std::vector<ReliefBar> relief_bars(const ReliefChart& chart);

/// The picture: 8 bits a channel, sRGB. Throws as relief_bars does.
Image relief_chart(const ReliefChart& chart);

/// Sets the pixels of a height map that are not over a bar to `ground` (0 to 1), so that labels can
/// be read. `relief` has the chart's film.
void flatten_beside(const std::vector<ReliefBar>& bars, float ground, Image& relief);

} // namespace integral

#endif
