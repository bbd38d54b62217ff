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

/// Views across and up, and the size of the whole quilt in pixels.
struct PanelQuilt {
    ViewGrid tiles;
    int width, height;
};

/// A quilt that a display's maker recommends. Of several for one display, the newest comes first.
struct RecommendedQuilt {
    std::string panel; ///< its name among known_panels
    PanelQuilt quilt;
};
const std::vector<RecommendedQuilt>& recommended_quilts();

/// The recommended quilt of a known display, or of a panel with its pixels and its size. For
/// another panel or another grid (`tiles`; nothing: the recommended one, else 8 x 6): tiles of the
/// panel's shape, with 1.5 times the panel's pixels times three in all, at most 8192 a side.
PanelQuilt quilt_for(const Panel& panel, const std::optional<ViewGrid>& tiles = {});

} // namespace integral

#endif
