// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes the settings with which povray-integral renders for a panel: its own image, or a quilt.
#ifndef INTEGRAL_SHEET_PANEL_RENDER_H
#define INTEGRAL_SHEET_PANEL_RENDER_H

#include "integral/sheet/panel_quilt.h"

#include <optional>
#include <string>

namespace integral {

/// Settings of a render for a panel.
struct PanelRender {
    PixelSize size;                ///< Width= and Height=
    std::string camera;            ///< the words of Integral_Camera=, without fit
    std::string fit;               ///< fit, the last of these words
    std::optional<ViewGrid> quilt; ///< Integral_Quilt=; nothing: the panel's own image
};

/// Settings for the panel's own image or, with `quilt`, for that quilt.
PanelRender panel_render(const Panel& panel, const std::optional<PanelQuilt>& quilt);

/// The settings as lines of an INI file.
std::string ini_text(const PanelRender& render);

/// Values of Integral_Panel= and Integral_Quilt=, and the size that the user gives.
struct PanelRequest {
    std::string panel;                ///< a name or a file (find_panel); empty: not given
    std::string quilt;                ///< CxR, draft, good or best; empty: the panel's own image
    std::optional<int> width, height; ///< +W and +H; > 0
};

/// Settings for a request. A given size must be the panel's own; a quilt's must have views whose
/// shape is the panel's or that of the maker's quilt, to a tenth, or lies between these two. If
/// only one side of a quilt is given, the other follows. Throws std::invalid_argument with the
/// right size in the message, InputError for a file that cannot be used.
PanelRender panel_render(const PanelRequest& request);

} // namespace integral

#endif
