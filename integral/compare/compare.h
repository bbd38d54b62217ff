// SPDX-License-Identifier: AGPL-3.0-or-later
// How far two pictures are apart.
#ifndef INTEGRAL_COMPARE_COMPARE_H
#define INTEGRAL_COMPARE_COMPARE_H

#include "integral/compare/flip.h"
#include "integral/compare/pixel_weights.h"
#include "integral/lightfield/frame.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace integral {

/// The lens whose micro-image, the film's pixels that are nearest to it, differs most.
struct WorstMicroImage {
    LensIndex lens;
    Vec2 pole; ///< mm, sheet frame
    double rmse = 0;
};

/// Pixels with a channel that is NaN or infinite.
struct NotFinitePixels {
    std::int64_t equal = 0;   ///< every such channel has the same value in both pictures
    std::int64_t unequal = 0; ///< a channel is so in one picture only, or not the same in both
    int x = 0, y = 0;         ///< the first of the unequal ones, row by row
};

struct SeenFigures; // seen.h

constexpr double default_channel_tolerance = 2.0 / 255;

/// What a comparison computes, and what it leaves out.
struct ComparisonSettings {
    bool similarity = true; ///< without it the SSIM is left 0, which saves most of the time
    /// A pixel differs where one of its channels differs by more than this.
    double channel_tolerance = default_channel_tolerance;
    /// Empty: every pixel counts as 1. A pixel of weight 0 has the first picture's colour in both.
    std::shared_ptr<const PixelWeights> weights;
    std::optional<FlipSettings> flip;
    Flip::TakeMap take_map; ///< takes the FLIP map; may be empty
};

/// Figures in the output encoding, 0..1 at full scale. Means, shares and sums are weighted.
///
/// NaN equals NaN, and infinity equals infinity of the same sign. A channel that is NaN or infinite
/// and unequal is a difference that has no size: it is counted in `not_finite`, and the
/// figures are over all other channels (NaN where there are none). SSIM and FLIP take it as 0 in
/// both.
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
    double differing = 0;  ///< fraction of pixels with a channel that differs by more than this:
    double channel_tolerance = default_channel_tolerance;
    std::optional<FlipFigures> flip; ///< of the linear light; empty unless asked for
    Encoding encoding;               ///< in which the figures were computed
    NotFinitePixels not_finite;
    /// By the metadata of the first picture that has some; empty where neither has, or where no
    /// lens has a channel that the figures are over.
    std::optional<WorstMicroImage> worst;
    /// False: the sizes differ, so that only what eyes see is compared; the figures are NaN.
    bool of_pixels = true;
    /// What eyes see of the frames, which limits are then for; empty unless asked for.
    std::shared_ptr<const SeenFigures> seen;
};

/// Compares two pictures that come row by row.
class Comparer {
public:
    /// `a` and `b` give the pictures' forms and metadata; their samples are not used. Throws
    /// std::invalid_argument if the sizes differ.
    Comparer(const Frame& a, const Frame& b, const ComparisonSettings& settings = {});
    ~Comparer();

    /// Takes the next rows of both pictures, the same number of each.
    void add(const Image& a, const Image& b);

    /// The figures, after all rows have been added.
    Comparison result() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Compares two pictures in memory. Throws std::invalid_argument if the sizes differ.
Comparison compare(const Frame& a, const Frame& b, const ComparisonSettings& settings = {});

/// Throws std::invalid_argument if the sizes differ.
void require_same_size(const Image& a, const Image& b);

/// |a - b| of the colours as `compare` sees them, times `gain`: three channels, encoded as
/// compared. 8 bits if both pictures have 8, else 16. Also for some rows of both pictures, of which
/// the first is row `first_row` of those that `weights` are for. Full scale where a channel is NaN
/// or infinite and unequal; 0 where the weight is 0.
Image difference_picture(const Image& a, const Image& b, double gain = 1,
                         const PixelWeights* weights = nullptr, int first_row = 0);

/// The form of the difference picture, without samples.
Image difference_form(const Image& a, const Image& b);

} // namespace integral

#endif
