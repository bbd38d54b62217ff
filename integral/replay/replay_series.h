// SPDX-License-Identifier: AGPL-3.0-or-later
// What a replay shows: one view, a pair or a grid of views, of an eye that stays or moves.
#ifndef INTEGRAL_REPLAY_REPLAY_SERIES_H
#define INTEGRAL_REPLAY_REPLAY_SERIES_H

#include "integral/replay/arrange.h"

#include <functional>
#include <optional>
#include <vector>

namespace integral {

constexpr int largest_replay_side = 32768; ///< of a picture, pixels

/// The views that one picture shows: by default one alone.
struct ViewArrangement {
    std::optional<double> separation; ///< mm between the two eyes of a pair
    bool crossed = false;             ///< of a pair: the left eye's view is on the right
    bool anaglyph = false;            ///< of a pair: for red-cyan glasses, in one view's place
    bool half = false;                ///< of a pair: each view squeezed to half of its width
    int columns = 0, rows = 0;        ///< of a grid of eyes over the viewing zone; 0: none
};

/// Throws std::invalid_argument where the picture would have a side of more than
/// largest_replay_side pixels.
void check_size(const ViewArrangement& arrangement, const View& view);

/// How the eye moves, as eye_path has it.
struct EyeMovement {
    EyePath path = EyePath::turntable;
    std::optional<double> span;
    int steps = 48; ///< > 0
};

/// Whether the eye ends elsewhere than it begins, so that an animation plays it there and back.
bool ends_apart(const EyeMovement& movement);

/// Throws std::invalid_argument where the view cannot be seen of a frame of that geometry: its
/// focus is behind the eye, its film before the lenses, or its lens model needs a surface that the
/// lenses do not have.
void check_view(const View& view, const FrameMetadata& metadata);

struct ReplayRequest {
    View view; ///< its size is set
    ViewArrangement arrangement;
    std::optional<EyeMovement> movement;
    int threads = 0; ///< 0: one per core
};

/// The eyes of all pictures: one, or one for each step of the movement. Throws
/// std::invalid_argument where the movement leads the eye behind the sheet or before its focus.
std::vector<Eye> eyes_of(const ReplayRequest& request, const FrameMetadata& metadata);

/// Takes each picture in order.
using TakePicture = std::function<void(Image picture)>;

/// Draws all pictures of a frame that has metadata: one, or one for each step of the movement.
/// Returns whether all were drawn: false if `progress` stopped it. Throws std::invalid_argument as
/// check_size does, and where the movement leads the eye behind the sheet or before its focus; and
/// what `take` throws.
bool replay_pictures(const Frame& frame, const ReplayRequest& request, const TakePicture& take,
                     const Progress& progress = {});

} // namespace integral

#endif
