// SPDX-License-Identifier: AGPL-3.0-or-later
// Weights of pixels in a comparison: regions of a picture that are ignored or weighted.
#ifndef INTEGRAL_COMPARE_PIXEL_WEIGHTS_H
#define INTEGRAL_COMPARE_PIXEL_WEIGHTS_H

#include "integral/frame/frame.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace integral {

/// A part of a picture: a rectangle of pixels, or the micro-images of some lenses.
struct Region {
    std::string words; ///< as the user wrote it
    bool of_lenses = false;
    int x = 0, y = 0, width = 0, height = 0;                                     ///< pixels
    std::int64_t first_column = 0, last_column = 0, first_row = 0, last_row = 0; ///< lenses
    double weight = 0;                                                           ///< 0: ignored
};

/// Reads "X,Y,WxH" (pixels from the top left), or "lens:COLUMN,ROW" (as the worst micro-image is
/// named), in which either number may be a range, "lens:-2..5,0". Throws std::invalid_argument.
Region region_of(const std::string& words, double weight);

/// Weights of a picture's pixels: 1, times the mask's value, times the weight of each region that
/// the pixel lies in.
class PixelWeights {
public:
    /// `mask`: a picture of the same size, whose luma (stored values, 1 is white) is the weight;
    /// empty: none. `metadata` is needed for lenses. Throws std::invalid_argument where a region or
    /// the mask does not fit the picture, or if no pixel has a weight.
    PixelWeights(const std::vector<Region>& regions, const std::optional<Image>& mask, int width,
                 int height, const std::optional<FrameMetadata>& metadata);

    /// The weights of the pixels of row y, from the left.
    void fill(int y, float* weights) const;

private:
    std::vector<Region> regions_;
    std::optional<Image> mask_;
    int width_;
    std::optional<FrameMetadata> metadata_;
};

} // namespace integral

#endif
