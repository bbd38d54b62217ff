// SPDX-License-Identifier: AGPL-3.0-or-later
// Structural similarity of two pictures that come row by row.
#ifndef INTEGRAL_COMPARE_SIMILARITY_H
#define INTEGRAL_COMPARE_SIMILARITY_H

#include <cstddef>
#include <vector>

namespace integral {

/// Mean SSIM of Wang, Bovik, Sheikh and Simoncelli (2004): Gaussian window 11x11 of sigma 1.5,
/// K1 = 0.01, K2 = 0.03, range 1, over the windows that lie wholly in the picture (where a side
/// is shorter than 11, over windows cut at it and their weights made up to 1). Keeps as many rows
/// as a window has and those of one call of add.
class Similarity {
public:
    Similarity(int width, int height);

    /// The next rows of lumas, width x rows, row by row: 0.2126 R + 0.7152 G + 0.0722 B of the
    /// encoded values. At most `most_rows` at a time.
    void add(const float* a, const float* b, int rows);
    static constexpr int most_rows = 32;

    /// After all rows.
    double mean() const;

private:
    void take_row(int y, const float* a, const float* b);
    void add_centres(int y, std::vector<double>& terms) const;
    std::size_t place(int y, int moment) const;

    int width_, height_;
    int left_, right_, top_,
        bottom_; ///< the windows' centres: the first, and the one after the last
    std::vector<double> taps_;
    std::vector<double> ring_; ///< five weighted means across, at every centre, of the last rows
    int taken_ = 0, centred_ = 0;
    double total_ = 0;
};

/// The same of two pictures in memory.
double structural_similarity(const std::vector<float>& a, const std::vector<float>& b, int width,
                             int height);

} // namespace integral

#endif
