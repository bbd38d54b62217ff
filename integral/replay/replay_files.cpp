// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/replay/replay_files.h"

namespace integral {

bool replay_files(const std::vector<std::string>& paths, const ReadFrame& read, Frame first,
                  ReplayRequest request, const TakePicture& take, const Progress& progress)
{
    if (paths.size() == 1)
        return replay_pictures(first, request, take, progress);
    const std::vector<Eye> eyes = eyes_of(request, *first.metadata);
    request.movement.reset(); // replaced by one eye for each frame
    const int count = int(paths.size());
    for (int k = 0; k < count; ++k) {
        const Frame frame = k == 0 ? std::move(first) : read(paths[std::size_t(k)]);
        request.view.eye = eyes[eyes.size() > 1 ? std::size_t(k) : 0];
        check_view(request.view, *frame.metadata);
        if (!replay_pictures(frame, request, take, piece_of(progress, k, count)))
            return false;
    }
    return true;
}

} // namespace integral
