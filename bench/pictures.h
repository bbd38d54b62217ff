// SPDX-License-Identifier: AGPL-3.0-or-later
// Picture operations for the measurements: reduction, differences, and labelled tables of pictures.
#ifndef INTEGRAL_BENCH_PICTURES_H
#define INTEGRAL_BENCH_PICTURES_H

#include "integral/frame/image.h"

#include <string>
#include <vector>

namespace integral::bench {

/// The image reduced by `block` in both directions: each pixel is the mean of `block` x `block`
/// pixels, in linear light.
Image shrunk(const Image& image, int block);

/// Accumulates squared differences of colours, pixel by pixel.
class ColourDifferences {
public:
    void add(const Colour& a, const Colour& b);
    double rms() const; ///< over the three channels; 0 if nothing was added

private:
    double squares_ = 0;
    long long values_ = 0;
};

/// A table of pictures of one size, with labels.
struct LabelledPictures {
    std::vector<std::string> columns; ///< labels along the top
    std::vector<std::string> rows;    ///< labels on the left, written upwards
    std::vector<Image> pictures;      ///< row by row
    /// Writes a PNG of 8 bits, with each pixel drawn `times` as wide and high.
    void write(const std::string& path, int times) const;
};

} // namespace integral::bench

#endif
