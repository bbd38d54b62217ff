// SPDX-License-Identifier: AGPL-3.0-or-later
// Lists the panels that are known by name, and writes the settings that render for a panel.
#ifndef INTEGRAL_OUTPUT_PANEL_TEXT_H
#define INTEGRAL_OUTPUT_PANEL_TEXT_H

#include "integral/base/json.h"
#include "integral/lightfield/view_grid.h"
#include "integral/output/panel.h"

#include <optional>
#include <string>

namespace integral {

/// All of known_panels, as a table or as JSON.
std::string panels_text();
Json panels_json();

/// An INI file's lines with which povray-integral renders for a panel: its image, or a quilt of so
/// many views.
std::string render_settings(Panel panel, const std::optional<ViewGrid>& quilt);

} // namespace integral

#endif
