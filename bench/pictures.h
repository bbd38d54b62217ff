// SPDX-License-Identifier: AGPL-3.0-or-later
// Picture operations for the measurements: reduction, differences, and labelled tables of pictures.
#ifndef INTEGRAL_BENCH_PICTURES_H
#define INTEGRAL_BENCH_PICTURES_H

#include "integral/lightfield/image.h"

#include <string>
#include <vector>

namespace integral::bench {

/// Means over squares of `block` x `block` pixels, in linear light.
Image shrunk(const Image& image, int block);

/// Accumulates squared differences of colours, pixel by pixel.
class ColourDifferences {
public:
    void add(const Colour& a, const Colour& b);
    double rms() const; ///< over three channels; 0 where nothing was added

private:
    double squares_ = 0;
    long long values_ = 0;
};

/// Pictures of one size as a table, with their names.
struct LabelledPictures {
    std::vector<std::string> columns,
        rows;                    ///< as many labels; along the top, and upwards on the left
    std::vector<Image> pictures; ///< row by row
    /// A PNG of 8 bits, each pixel `times` as wide and high.
    void write(const std::string& path, int times) const;
};

} // namespace integral::bench

#endif
