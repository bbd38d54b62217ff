// SPDX-License-Identifier: AGPL-3.0-or-later
// Lowers the noise left in a reconstructed frame, by mixing pixels with their neighbours in the
// light field (LightFieldImage): pixels in their row and column behind the same lens, and pixels of
// the same direction behind the next lenses in a row. (Lenses in the rows above and below would
// lower the error by 0.4% more behind square lenses, but rendering a strip of a frame would need
// more rows around the strip.)
//
// A neighbour's colour is another estimate of the pixel's light. So is the mean of the two nearest
// neighbours along an axis; it is right even where the light changes linearly. An estimate differs
// from the pixel for two reasons: noise, whose expected square is known, and different light. The
// mean square of such differences over the pixels around measures both. The more it exceeds the
// expected noise, the less the estimate counts.
#ifndef INTEGRAL_RECONSTRUCTION_NOISE_FILTER_H
#define INTEGRAL_RECONSTRUCTION_NOISE_FILTER_H

#include "integral/base/four_floats.h"
#include "integral/reconstruction/light_field_image.h"
#include "integral/reconstruction/pass_schedule.h"

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace integral {

/// Filters a frame block by block. Different threads may filter different blocks.
class NoiseFilter {
public:
    /// Refers to `finished`, which must outlive this object. When a block is filtered, `finished`
    /// must contain the reconstructed frame's colours in and around it (LightFieldImage::recolour).
    NoiseFilter(const IntegralCamera& camera, const LightFieldImage& finished);
    /// The same for a quilt.
    explicit NoiseFilter(const LightFieldImage& finished);

    /// reach_around: half-width of the window over which squares are averaged. reach_along:
    /// distance of the furthest pixels that are mixed. rows: greatest distance, in rows, of a pixel
    /// that influences a filtered pixel.
    static constexpr int reach_around = 2, reach_along = 4, rows = reach_around + reach_along;

    /// Working memory of one thread.
    struct Scratch;
    struct FreeScratch {
        void operator()(Scratch* scratch) const;
    };
    using ScratchPointer = std::unique_ptr<Scratch, FreeScratch>;
    static ScratchPointer make_scratch();

    /// The squared error expected from noise in the light of pixel (x, y), in the encoding of
    /// ComparedColour, summed over its components; 0: the pixel is left unchanged.
    using Noise = std::function<float(int x, int y)>;

    /// Computes the changes to be added to the colours of a block's pixels, row by row, in the
    /// encoding of comparison. A changed colour lies between the smallest and the greatest value of
    /// the pixel and its neighbours, component by component.
    void filter(const PictureBlock& block, const Noise& noise, Scratch& scratch,
                std::vector<FourFloats>& changes) const;

private:
    struct Pixels;

    void read(const PictureBlock& block, const Noise& noise, Scratch& scratch) const;

    const LightFieldImage& finished_;
    std::array<float, 3> apart_; ///< fraction of a pixel's noise that the mean of two neighbours
                                 ///< does not share: in the row, the column, the next lenses
};

} // namespace integral

#endif
