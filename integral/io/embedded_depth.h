// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads the depth that phones store inside photographs: XMP GDepth (a picture as text in the
// metadata) and Dynamic Depth (a picture behind the photograph, listed in the metadata).
#ifndef INTEGRAL_IO_EMBEDDED_DEPTH_H
#define INTEGRAL_IO_EMBEDDED_DEPTH_H

#include "integral/frame/image.h"

#include <optional>
#include <string>

namespace integral {

/// The depth of a photograph, upright as the photograph is shown, of any number of pixels: white is
/// the nearest surface, and equal steps are equal steps of 1/distance. Floats, three equal
/// channels. Nothing for a file without depth. Throws InputError for a file, or a depth, that
/// cannot be read.
std::optional<Image> embedded_depth(const std::string& path);

/// The same for the bytes of a JPEG. Throws std::runtime_error.
std::optional<Image> depth_in_jpeg(const std::string& bytes);

} // namespace integral

#endif
