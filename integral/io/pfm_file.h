// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads and writes portable float maps (.pfm), in which light-field benchmarks store disparities.
#ifndef INTEGRAL_IO_PFM_FILE_H
#define INTEGRAL_IO_PFM_FILE_H

#include <string>
#include <vector>

namespace integral {

/// A plane of floats, row by row from the top left.
struct FloatMap {
    int width = 0, height = 0;
    std::vector<float> values;
};

/// Reads a grey map, or the first channel of a coloured one, in either byte order. Throws
/// InputError.
FloatMap read_pfm(const std::string& path);

/// Writes a grey map. Throws OutputError.
void write_pfm(const std::string& path, const FloatMap& map);

} // namespace integral

#endif
