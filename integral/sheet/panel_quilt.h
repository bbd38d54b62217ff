// SPDX-License-Identifier: AGPL-3.0-or-later
// Chooses the quilt that a panel is given: how many views, and how many pixels.
#ifndef INTEGRAL_SHEET_PANEL_QUILT_H
#define INTEGRAL_SHEET_PANEL_QUILT_H

#include "integral/frame/view_grid.h"
#include "integral/sheet/panel.h"

#include <optional>
#include <string>
#include <vector>

namespace integral {

/// A quilt that a display's maker recommends. Of several for one display, the newest comes first.
struct RecommendedQuilt {
    std::string panel; ///< its name among known_panels
    PanelQuilt quilt;
};
const std::vector<RecommendedQuilt>& recommended_quilts();

/// Sizes of quilts. Draft has a quarter, and good half, of best's pixels across and down.
enum class QuiltSize { draft, good, best };

/// The size with that name: draft, good or best; nothing for other names.
std::optional<QuiltSize> quilt_size(const std::string& name);

constexpr int most_views_of_quilt = 256; ///< across, and up

/// Views across and up in a text such as "8x6", each from 1 to most_views_of_quilt; nothing for
/// other texts.
std::optional<ViewGrid> views_in(const std::string& text);

/// Best is the quilt that the display's own file reports, else the newest recommended quilt of a
/// known display, or of a panel with its pixels and its size; with `tiles`, such a quilt of that
/// grid. For another panel or another grid
/// (default: 8 x 6): tiles of the panel's shape, with 1.5 times the panel's pixels times three in
/// all, at most 8192 a side.
PanelQuilt quilt_for(const Panel& panel, const std::optional<ViewGrid>& tiles = {},
                     QuiltSize size = QuiltSize::best);

} // namespace integral

#endif
