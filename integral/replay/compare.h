// SPDX-License-Identifier: AGPL-3.0-or-later
// How far two pictures are apart.
#ifndef INTEGRAL_REPLAY_COMPARE_H
#define INTEGRAL_REPLAY_COMPARE_H

#include "integral/lightfield/frame.h"

#include <optional>

namespace integral {

/// The lens whose share of the film (the pixels nearest to it) differs most.
struct WorstMicroImage {
    LensIndex lens;
    Vec2 pole;       ///< mm, sheet frame
    double rmse = 0;
};

/// Figures in the output encoding, 0..1 at full scale.
///
/// Colours are compared over black (where alpha is 1, as they are); alpha is a fourth channel
/// where both pictures have it, and ignored otherwise. If the encodings differ, the
/// one that is not linear is used for both (the first's, if neither is).
struct Comparison {
    double rmse = 0;               ///< over all channels of all pixels
    double psnr = 0;               ///< dB, -20 log10(rmse); infinite where the pictures are equal
    double ssim = 0;               ///< mean structural similarity of the lumas, see structural_similarity
    double largest_difference = 0; ///< of any channel of any pixel
    double within_two = 0;         ///< fraction of pixels of which no channel differs by more than 2/255
    Encoding encoding;             ///< that of the figures
    std::optional<WorstMicroImage> worst; ///< where either picture has metadata (the first's, if both)
};

/// Throws std::invalid_argument if the sizes differ.
Comparison compare(const Frame& a, const Frame& b);

/// |a - b| of the colours as `compare` sees them, times `gain`: three channels, encoded as compared.
/// 8 bits if both pictures have 8, else 16.
Image difference_picture(const Image& a, const Image& b, double gain = 1);

/// Mean SSIM of Wang, Bovik, Sheikh and Simoncelli (2004): Gaussian window 11x11 of sigma 1.5,
/// K1 = 0.01, K2 = 0.03, range 1, over the windows that lie wholly in the picture (where a side
/// is shorter than 11, over windows cut at it and their weights made up to 1). The lumas are
/// width x height, row by row: 0.2126 R + 0.7152 G + 0.0722 B of the encoded values.
double structural_similarity(const std::vector<float>& a, const std::vector<float>& b, int width,
                             int height);

} // namespace integral

#endif
