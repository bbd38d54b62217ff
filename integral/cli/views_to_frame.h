// SPDX-License-Identifier: AGPL-3.0-or-later
// integral views --to-frame: the frame that shows the views of a quilt, or of files.
#ifndef INTEGRAL_CLI_VIEWS_TO_FRAME_H
#define INTEGRAL_CLI_VIEWS_TO_FRAME_H

#include "integral/cli/command.h"

#include <string>

namespace integral {

/// The way back: returns an ExitStatus or throws, as a command does.
int frame_of_views(const options::variables_map& arguments, const std::string& output, int threads);

} // namespace integral

#endif
