// SPDX-License-Identifier: AGPL-3.0-or-later
// A look at an OpenEXR file's header before OpenEXR reads it.
#ifndef INTEGRAL_IO_EXR_HEADER_H
#define INTEGRAL_IO_EXR_HEADER_H

#include "integral/io/input_file.h"

namespace integral {

/// Throws std::runtime_error unless the attributes of the header (of each, in a file of several
/// parts) are whole and as long as their types are. OpenEXR reads most types without looking at the
/// length that stands before them, and takes what follows for the next attribute; and it makes room
/// for an attribute before it looks whether the file holds it, and for a tile: up to 2 GB and more,
/// which bytes of a picture can ask for. So tiles have at most 4096 x 4096 pixels.
void check_exr_header(const InputFile& file);

} // namespace integral

#endif
