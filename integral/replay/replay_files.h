// SPDX-License-Identifier: AGPL-3.0-or-later
// Replays the frames of several files, such as an animation's, as one picture each.
#ifndef INTEGRAL_REPLAY_REPLAY_FILES_H
#define INTEGRAL_REPLAY_REPLAY_FILES_H

#include "integral/replay/replay_series.h"

#include <string>
#include <vector>

namespace integral {

/// Reads a frame with metadata, as it is to be replayed. Throws InputError.
using ReadFrame = std::function<Frame(const std::string& path)>;

/// Draws one frame as replay_pictures does, or one picture of each of several frames. The eye then
/// moves by one step from frame to frame, so a movement must have as many steps as there are
/// frames. `first` is the frame of the first path; `read` reads the others. Returns and throws as
/// replay_pictures, check_view and `read` do.
bool replay_files(const std::vector<std::string>& paths, const ReadFrame& read, Frame first,
                  ReplayRequest request, const TakePicture& take, const Progress& progress);

} // namespace integral

#endif
