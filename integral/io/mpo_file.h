// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads and writes multi-picture files (MPO, CIPA DC-007-2009): several JPEGs in succession, with
// an index of them in the first. 3D cameras, televisions and viewers support files of two views.
#ifndef INTEGRAL_IO_MPO_FILE_H
#define INTEGRAL_IO_MPO_FILE_H

#include "integral/frame/image.h"

#include <string>
#include <vector>

namespace integral {

/// The bytes of a file of views, the leftmost first: disparity images, sRGB, 8 bits. `quality` of
/// the JPEGs: 0 to 100. `baseline`: mm between the eyes of neighbouring views. Throws
/// std::runtime_error.
std::string mpo_of_views(const std::vector<Image>& views, int quality, double baseline);

/// Writes a file of the two views that stand side by side in `pair`. Throws OutputError.
void write_mpo(const std::string& path, const Image& pair, int quality, double baseline);

/// Offsets of the pictures in an MPO's bytes, in the index's order; the first offset is 0. Empty
/// for other files, including plain JPEGs. Throws std::runtime_error if the index makes no sense.
std::vector<std::size_t> pictures_in_mpo(const std::string& bytes);

} // namespace integral

#endif
