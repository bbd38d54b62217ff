// SPDX-License-Identifier: AGPL-3.0-or-later
// Replays the frames of several files, as of an animation: a picture of each.
#ifndef INTEGRAL_REPLAY_REPLAY_FILES_H
#define INTEGRAL_REPLAY_REPLAY_FILES_H

#include "integral/replay/replay_series.h"

#include <string>
#include <vector>

namespace integral {

/// Reads a frame with metadata, as it is to be replayed. Throws InputError.
using ReadFrame = std::function<Frame(const std::string& path)>;

/// Draws what replay_pictures draws of one frame, or a picture of each of several. Their movement
/// goes on from frame to frame, so it has as many steps as there are frames. `first` is the frame
/// of the first path; `read` reads the others. Returns and throws as replay_pictures, check_view and
/// `read` do.
bool replay_files(const std::vector<std::string>& paths, const ReadFrame& read, Frame first,
                  ReplayRequest request, const TakePicture& take, const Progress& progress);

} // namespace integral

#endif
