// SPDX-License-Identifier: AGPL-3.0-or-later
// Two pictures compared while they are read, and their difference written.
#ifndef INTEGRAL_COMPARE_COMPARE_FILES_H
#define INTEGRAL_COMPARE_COMPARE_FILES_H

#include "integral/compare/compare.h"
#include "integral/io/image_file.h"

#include <string>

namespace integral {

/// Compares two pictures of which no row has been read; only some rows of each are in memory at a
/// time. Writes their difference, times `gain`, to the file `difference`, unless that is empty.
/// `name_of_b` is what a complaint about their sizes calls the second. Throws InputError,
/// OutputError, Interrupted.
Comparison compare_files(FrameReader& a, FrameReader& b, const std::string& name_of_b,
                         const std::string& difference, double gain);

} // namespace integral

#endif
