// SPDX-License-Identifier: AGPL-3.0-or-later
// Draws the pictures of a replay: one view, a pair or a grid of views, for an eye that stays or
// moves.
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
    bool anaglyph = false;            ///< of a pair: one picture for red-cyan glasses
    bool half = false;                ///< of a pair: each view squeezed to half of its width
    int columns = 0, rows = 0;        ///< of a grid of eyes over the viewing zone; 0: none
};

/// Throws std::invalid_argument if the picture would have a side of more than largest_replay_side
/// pixels.
void check_size(const ViewArrangement& arrangement, const View& view);

/// The movement of the eye, as in eye_path.
struct EyeMovement {
    EyePath path = EyePath::turntable;
    std::optional<double> span;
    int steps = 48; ///< > 0
};

/// Whether the eye ends elsewhere than it begins, so that an animation plays it there and back.
bool ends_apart(const EyeMovement& movement);

/// Throws std::invalid_argument if a frame of that geometry cannot be seen in this view: the focus
/// is behind the eye, the film is in front of the lenses, or the lens model needs a surface that
/// the lenses lack.
void check_view(const View& view, const FrameMetadata& metadata);

struct ReplayRequest {
    View view; ///< its width and height are set
    ViewArrangement arrangement;
    std::optional<EyeMovement> movement;
    int threads = 0; ///< 0: one per core
};

/// The eyes of all pictures: one, or one for each step of the movement. Throws
/// std::invalid_argument if the movement leads the eye behind the sheet or past its focus.
std::vector<Eye> eyes_of(const ReplayRequest& request, const FrameMetadata& metadata);

/// Takes each picture in order.
using TakePicture = std::function<void(Image picture)>;

/// Draws all pictures of a frame that has metadata: one, or one for each step of the movement.
/// Returns false if `progress` stopped the work. Throws std::invalid_argument as check_size does,
/// and if the movement leads the eye behind the sheet or past its focus; and exceptions of `take`.
bool replay_pictures(const Frame& frame, const ReplayRequest& request, const TakePicture& take,
                     const Progress& progress = {});

} // namespace integral

#endif
