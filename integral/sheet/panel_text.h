// SPDX-License-Identifier: AGPL-3.0-or-later
// Lists the known panels, and writes the settings that render for a panel.
#ifndef INTEGRAL_SHEET_PANEL_TEXT_H
#define INTEGRAL_SHEET_PANEL_TEXT_H

#include "integral/base/json.h"
#include "integral/sheet/panel.h"
#include "integral/sheet/panel_quilt.h"

#include <optional>
#include <string>

namespace integral {

/// All of known_panels, as a table or as JSON.
std::string panels_text();
Json panels_json();

/// Lines of an INI file with which povray-integral renders for a panel: its image, or a quilt.
std::string render_settings(const Panel& panel, const std::optional<PanelQuilt>& quilt);

} // namespace integral

#endif
