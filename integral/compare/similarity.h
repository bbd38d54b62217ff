// SPDX-License-Identifier: AGPL-3.0-or-later
// Structural similarity of two pictures that come row by row.
#ifndef INTEGRAL_COMPARE_SIMILARITY_H
#define INTEGRAL_COMPARE_SIMILARITY_H

#include "integral/compare/pixel_weights.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace integral {

/// Computes the mean SSIM of Wang, Bovik, Sheikh and Simoncelli (2004): Gaussian window 11x11 of
/// sigma 1.5, K1 = 0.01, K2 = 0.03, range 1, over all windows that lie wholly in the picture. Along
/// a side shorter than 11 pixels, windows are cut at the picture's edge and their weights scaled to
/// add up to 1. A window has the weight of its centre. Keeps in memory the rows of one window and
/// of one call of add.
class Similarity {
public:
    /// `weights` of the centres; may be empty.
    Similarity(int width, int height, std::shared_ptr<const PixelWeights> weights = {});

    /// Takes the next rows of lumas, 0.2126 R + 0.7152 G + 0.0722 B of the encoded values: width x
    /// rows values of each picture, row by row; rows <= most_rows.
    void add(const float* a, const float* b, int rows);
    static constexpr int most_rows = 32;

    /// The mean, after all rows have been added; NaN where no window has weight.
    double mean() const;

private:
    void take_row(int y, const float* a, const float* b);
    void add_centres(int y, std::vector<double>& terms) const;
    std::vector<float> weights_of_centres(int y) const;
    std::size_t place(int y, int moment) const;

    int width_, height_;
    /// The windows' centres: [left_, right_) across and [top_, bottom_) down.
    int left_, right_, top_, bottom_;
    std::vector<double> taps_;
    /// A ring of the last rows: for each centre across, five means weighted along the row.
    std::vector<double> ring_;
    int taken_ = 0, centred_ = 0;
    std::shared_ptr<const PixelWeights> weights_;
    double total_ = 0, weight_ = 0;
};

/// The mean SSIM of two pictures in memory.
double structural_similarity(const std::vector<float>& a, const std::vector<float>& b, int width,
                             int height);

} // namespace integral

#endif
