// SPDX-License-Identifier: AGPL-3.0-or-later
// The micro-image frame: pixels and the geometry that makes a light field of them.
#ifndef INTEGRAL_LIGHTFIELD_FRAME_H
#define INTEGRAL_LIGHTFIELD_FRAME_H

#include "integral/lightfield/image.h"

#include <optional>

namespace integral {

/// A picture, and its geometry where it is known: a view, a scan or another program's picture
/// has none. With metadata, metadata->film's size is the image's and its encoding the image's.
struct Frame {
    Image image;
    std::optional<FrameMetadata> metadata;
};

/// Gives a frame its geometry. A film size of 0 by 0 is taken from the image.
/// Throws std::invalid_argument where the geometry is of a frame of another size.
void set_metadata(Frame& frame, FrameMetadata metadata);

} // namespace integral

#endif
