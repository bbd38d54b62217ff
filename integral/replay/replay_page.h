// SPDX-License-Identifier: AGPL-3.0-or-later
// A frame's replay as one HTML page that needs nothing but a browser with WebGL 2.
#ifndef INTEGRAL_REPLAY_REPLAY_PAGE_H
#define INTEGRAL_REPLAY_REPLAY_PAGE_H

#include "integral/replay/replay.h"

#include <string>

namespace integral {

/// The page for a frame that has metadata: shows what replay() shows, of the frame at 8 bits and
/// sRGB (light beyond full scale is cut), over black. `start` is where the eye is at first; its
/// size may be 0 by 0, which is as large as the window allows. Its model: pinhole or
/// extended_pinhole. Throws std::invalid_argument where the film has subpixels other than upright
/// stripes, rgb or bgr, which the page cannot show.
std::string replay_page(const Frame& frame, const View& start);

} // namespace integral

#endif
