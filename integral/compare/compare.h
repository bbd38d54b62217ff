// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares two pictures pixel by pixel.
#ifndef INTEGRAL_COMPARE_COMPARE_H
#define INTEGRAL_COMPARE_COMPARE_H

#include "integral/compare/flip.h"
#include "integral/compare/pixel_weights.h"
#include "integral/frame/frame.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace integral {

/// The lens whose micro-image, the film pixels nearest to it, differs most.
struct WorstMicroImage {
    LensIndex lens;
    Vec2 pole; ///< mm, sheet frame
    double rmse = 0;
};

/// Pixels with a channel that is NaN or infinite.
struct NotFinitePixels {
    std::int64_t equal = 0;   ///< each of these channels has the same value in both pictures
    std::int64_t unequal = 0; ///< one is not finite in one picture only, or its values differ
    int x = 0, y = 0;         ///< the first of the unequal ones, row by row
};

struct SeenFigures; // seen.h

constexpr double default_channel_tolerance = 2.0 / 255;

/// Options for what a comparison computes and leaves out.
struct ComparisonSettings {
    bool similarity = true; ///< without it the SSIM is left 0, which saves most of the time
    /// A pixel differs where one of its channels differs by more than this.
    double channel_tolerance = default_channel_tolerance;
    /// Empty: every pixel counts as 1. A pixel of weight 0 takes the first picture's colour in
    /// both.
    std::shared_ptr<const PixelWeights> weights;
    std::optional<FlipSettings> flip;
    Flip::TakeMap take_map; ///< takes the FLIP map; may be empty
};

/// Figures in the output encoding, 0..1 at full scale. Means, shares and sums are weighted.
///
/// NaN equals NaN, and infinity equals infinity of the same sign. If a channel is NaN or infinite
/// and differs between the pictures, the difference has no size: `not_finite` counts its pixel, and
/// the figures are over all other channels (NaN without any). SSIM and FLIP take a channel that is
/// not finite in either picture as 0 in both.
///
/// Colours are laid over black before they are compared (no change where alpha is 1); alpha is a
/// fourth channel if both pictures have it, and ignored otherwise. If the encodings differ, the
/// non-linear one is used for both (the first's, if neither is linear).
struct Comparison {
    double rmse = 0;               ///< over all channels of all pixels
    double psnr = 0;               ///< dB, -20 log10(rmse); infinite where the pictures are equal
    double ssim = 0;               ///< mean structural similarity of the lumas, see similarity.h
    double largest_difference = 0; ///< of any channel of any pixel
    double within_two = 0; ///< fraction of pixels without a channel that differs by more than 2/255
    double differing = 0;  ///< fraction of pixels with a channel that differs by more than this:
    double channel_tolerance = default_channel_tolerance;
    std::optional<FlipFigures> flip; ///< of the linear light; empty unless requested
    Encoding encoding;               ///< in which the figures were computed
    NotFinitePixels not_finite;
    /// Uses the metadata of the first picture that has some; empty where neither has, or where no
    /// lens has a channel that counts in the figures.
    std::optional<WorstMicroImage> worst;
    /// False: the sizes differ, so that only the eyes' views are compared; the figures are NaN.
    bool of_pixels = true;
    /// Figures of the eyes' views, to which limits then apply; empty unless requested.
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

/// |a - b| of the colours as `compare` takes them, times `gain`: three channels, encoded as
/// compared. 8 bits if both pictures have 8, else 16. Also works with bands of rows: then
/// `first_row` is a band's first row in the whole picture, for which `weights` are. A channel that
/// is NaN or infinite, and unequal, is full scale; pixels of weight 0 are 0.
Image difference_picture(const Image& a, const Image& b, double gain = 1,
                         const PixelWeights* weights = nullptr, int first_row = 0);

/// The form of the difference picture, without samples.
Image difference_form(const Image& a, const Image& b);

} // namespace integral

#endif
