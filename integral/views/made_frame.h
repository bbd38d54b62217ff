// SPDX-License-Identifier: AGPL-3.0-or-later
// Metadata and encoding of a frame that is made from frames or pictures.
#ifndef INTEGRAL_VIEWS_MADE_FRAME_H
#define INTEGRAL_VIEWS_MADE_FRAME_H

#include "integral/frame/image.h"

namespace integral {

/// Removes what describes one rendered scene: placement, parallax, and `render` except model,
/// mapping and pseudoscopic, which the lines of sight depend on.
inline void remove_scene(FrameMetadata& metadata)
{
    metadata.placement.reset();
    metadata.parallax.reset();
    if (!metadata.render)
        return;
    RenderRecord rays;
    rays.model = metadata.render->model;
    rays.mapping = metadata.render->mapping;
    rays.pseudoscopic = metadata.render->pseudoscopic;
    metadata.render = rays;
}

/// The encoding of a frame with `bits` per sample whose first input is `first`: that of `first`,
/// but sRGB for linear light in fewer bits, which would be too coarse in the shadows.
inline Encoding encoding_of_made(int bits, const Image& first)
{
    const bool coarse = bits < sample_bits(first);
    return coarse && first.encoding.kind == Encoding::Kind::linear ? Encoding() : first.encoding;
}

} // namespace integral

#endif
