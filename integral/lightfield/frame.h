// SPDX-License-Identifier: AGPL-3.0-or-later
// The micro-image frame: a picture and the geometry that maps its pixels to rays.
#ifndef INTEGRAL_LIGHTFIELD_FRAME_H
#define INTEGRAL_LIGHTFIELD_FRAME_H

#include "integral/lightfield/image.h"

#include <optional>

namespace integral {

/// A picture, and its geometry if that is known. Views, scans and other programs' pictures have
/// none. The size of metadata->film and metadata->encoding equal those of the image.
struct Frame {
    Image image;
    std::optional<FrameMetadata> metadata;
};

/// Sets a frame's geometry. A film size of 0 by 0 means the image's size. Throws
/// std::invalid_argument if the film has another size than the image.
void set_metadata(Frame& frame, FrameMetadata metadata);

} // namespace integral

#endif
