// SPDX-License-Identifier: AGPL-3.0-or-later
// The micro-image frame: a picture and the geometry that maps its pixels to rays.
#ifndef INTEGRAL_FRAME_FRAME_H
#define INTEGRAL_FRAME_FRAME_H

#include "integral/frame/image.h"

#include <optional>

namespace integral {

/// A picture, and its geometry if known (not for scans, for example). metadata->film and
/// metadata->encoding have the image's size and encoding.
struct Frame {
    Image image;
    std::optional<FrameMetadata> metadata;
};

/// Sets a frame's geometry. A film size of 0 by 0 means the image's size. Throws
/// std::invalid_argument if the film's size differs from the image's.
void set_metadata(Frame& frame, FrameMetadata metadata);

} // namespace integral

#endif
