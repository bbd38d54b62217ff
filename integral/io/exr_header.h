// SPDX-License-Identifier: AGPL-3.0-or-later
// Checks an OpenEXR file's header before OpenEXR reads it.
#ifndef INTEGRAL_IO_EXR_HEADER_H
#define INTEGRAL_IO_EXR_HEADER_H

#include "integral/io/input_file.h"

namespace integral {

/// Throws std::runtime_error unless every attribute of the header (of each header, in a multi-part
/// file) is complete and has the length of its type, and tiles have at most 4096 x 4096 pixels.
/// OpenEXR itself ignores the stored length of most attribute types, and so misreads the attributes
/// after a wrong length. It also allocates memory for attributes and tiles before it checks that
/// the file contains them, which lets a malformed file allocate more than 2 GB.
void check_exr_header(const InputFile& file);

} // namespace integral

#endif
