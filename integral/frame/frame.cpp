// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/frame/frame.h"

#include <stdexcept>

namespace integral {

void set_metadata(Frame& frame, FrameMetadata metadata)
{
    const auto size = [](int w, int h) { return std::to_string(w) + "x" + std::to_string(h); };
    if (metadata.film.width == 0 && metadata.film.height == 0) {
        metadata.film.width = frame.image.width;
        metadata.film.height = frame.image.height;
    }
    if (metadata.film.width != frame.image.width || metadata.film.height != frame.image.height)
        throw std::invalid_argument(
            "the geometry is of a frame of " + size(metadata.film.width, metadata.film.height) +
            " pixels, the image has " + size(frame.image.width, frame.image.height));
    metadata.encoding = frame.image.encoding;
    frame.metadata = metadata;
}

} // namespace integral
