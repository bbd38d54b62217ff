// SPDX-License-Identifier: AGPL-3.0-or-later
// Lists the known panels.
#ifndef INTEGRAL_SHEET_PANEL_TEXT_H
#define INTEGRAL_SHEET_PANEL_TEXT_H

#include "integral/base/json.h"

#include <string>

namespace integral {

/// All of known_panels, as a table or as JSON.
std::string panels_text();
Json panels_json();

} // namespace integral

#endif
