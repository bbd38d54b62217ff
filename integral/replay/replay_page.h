// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes an interactive replay of a frame as one HTML page for any browser with WebGL 2.
#ifndef INTEGRAL_REPLAY_REPLAY_PAGE_H
#define INTEGRAL_REPLAY_REPLAY_PAGE_H

#include "integral/replay/replay.h"

#include <string>

namespace integral {

/// The page for a frame that has metadata. It shows the same as replay(), over black, for the frame
/// converted to 8-bit sRGB (values above full scale are clamped). `start` is the first view; if its
/// size is 0 by 0, the page uses the size of the window. The model must be pinhole or
/// extended_pinhole. Throws std::invalid_argument where the film has subpixels other than upright
/// stripes, rgb or bgr, which the page cannot show.
std::string replay_page(const Frame& frame, const View& start);

/// The page for two frames of one geometry: what the eye sees of the reference left of a line that
/// the reader moves, and of the result right of it, or both in turn. Throws as replay_page does,
/// and where sizes or geometries differ.
std::string comparison_page(const Frame& reference, const Frame& result, const View& start);

} // namespace integral

#endif
