// SPDX-License-Identifier: AGPL-3.0-or-later
// The error of a halftone as eyes see it through lenticular lenses, block of rows by block.
#ifndef INTEGRAL_PRINT_SEEN_ERROR_H
#define INTEGRAL_PRINT_SEEN_ERROR_H

#include "integral/frame/frame_metadata.h"

#include <vector>

namespace integral {

/// The mean square of what eyes at all places see of a halftone's errors e is the sum of
/// R(d) e(p) e(p + d) over all pixels p and distances d. R is the autocorrelation of an eye's
/// window on the film: across the lenses, its pupil's image there and the printed dot; along them,
/// the blur of the eye itself at the viewing distance, too (two Gaussians, after Kim and Allebach
/// 2002). This class holds the sums E(p) of R(d) e(p + d), which direct binary search needs.
class SeenError {
public:
    explicit SeenError(const FrameMetadata& metadata);

    /// R of two pixels dx columns and dy rows apart.
    float coupling(int dx, int dy) const;

    /// Forgets all rows.
    void restart();

    /// Begins the next block, whose pixels have these errors, row by row. E includes the errors of
    /// all blocks above.
    void begin(const std::vector<float>& errors, int rows);

    /// E at a pixel of the block.
    float at(int x, int y) const { return sums_[std::size_t(y) * width_ + x]; }

    /// Changes the error of a pixel of the block.
    void change(int x, int y, float by);

    /// Ends the block: its errors are final.
    void end();

private:
    /// R of the pixels of one row, from column `first` on, 0 being the pixel itself.
    struct Taps {
        int first = 0;
        std::vector<float> values;
    };
    const Taps& taps(int dy) const { return taps_[std::size_t(dy + reach_)]; }

    int width_, reach_, rows_ = 0; ///< reach: rows up and down for which R is not 0
    std::vector<Taps> taps_;
    std::vector<float> sums_; ///< of the block's rows, and of `reach` rows below it
};

} // namespace integral

#endif
