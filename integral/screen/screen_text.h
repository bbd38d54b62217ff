// SPDX-License-Identifier: AGPL-3.0-or-later
// Reports the desktop's displays, and how a sequence of pictures was played, as text and as JSON.
#ifndef INTEGRAL_SCREEN_SCREEN_TEXT_H
#define INTEGRAL_SCREEN_SCREEN_TEXT_H

#include "integral/base/json.h"
#include "integral/screen/screen_window.h"

#include <string>
#include <vector>

namespace integral {

/// A line or an object for each display, numbered from 1.
std::string screens_text(const std::vector<Screen>& screens);
Json screens_json(const std::vector<Screen>& screens);

std::string play_text(const PlayReport& report);
Json play_json(const PlayReport& report);

} // namespace integral

#endif
