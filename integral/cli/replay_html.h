// SPDX-License-Identifier: AGPL-3.0-or-later
// replay's option --html: the interactive page.
#ifndef INTEGRAL_CLI_REPLAY_HTML_H
#define INTEGRAL_CLI_REPLAY_HTML_H

#include "integral/cli/command.h"
#include "integral/replay/replay.h"

namespace integral {

/// Whether --html was given. Throws UsageError where it does not go with another option.
bool html_is_wanted(const options::variables_map& arguments);

/// Writes the page to --html's FILE. The start's size is --size, or 0 by 0. Throws OutputError.
void write_html(const options::variables_map& arguments, const Frame& frame, const View& start);

} // namespace integral

#endif
