// SPDX-License-Identifier: AGPL-3.0-or-later
// How far two pictures are apart.
#ifndef INTEGRAL_COMPARE_COMPARE_H
#define INTEGRAL_COMPARE_COMPARE_H

#include "integral/lightfield/frame.h"

#include <memory>
#include <optional>

namespace integral {

/// The lens whose share of the film (the pixels nearest to it) differs most.
struct WorstMicroImage {
    LensIndex lens;
    Vec2 pole; ///< mm, sheet frame
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
    double ssim = 0;               ///< mean structural similarity of the lumas, see similarity.h
    double largest_difference = 0; ///< of any channel of any pixel
    double within_two = 0; ///< fraction of pixels of which no channel differs by more than 2/255
    Encoding encoding;     ///< that of the figures
    std::optional<WorstMicroImage> worst; ///< where either picture has metadata (the first's, if
                                          ///< both)
};

/// Compares two pictures that come row by row.
class Comparer {
public:
    /// `a` and `b`: the pictures' forms (their samples are not looked at) and metadata. Without
    /// `similarity` the SSIM is left 0, which saves most of the time. Throws std::invalid_argument
    /// if the sizes differ.
    Comparer(const Frame& a, const Frame& b, bool similarity = true);
    ~Comparer();

    /// The next rows of both: as many of the one as of the other.
    void add(const Image& a, const Image& b);

    /// After all rows.
    Comparison result() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Throws std::invalid_argument if the sizes differ.
Comparison compare(const Frame& a, const Frame& b);

/// |a - b| of the colours as `compare` sees them, times `gain`: three channels, encoded as
/// compared. 8 bits if both pictures have 8, else 16. Of rows as of whole pictures.
Image difference_picture(const Image& a, const Image& b, double gain = 1);

/// The form of that.
Image difference_form(const Image& a, const Image& b);

} // namespace integral

#endif
