// SPDX-License-Identifier: AGPL-3.0-or-later
// Lowers the noise that a reconstructed frame has left, by mixing pixels with their neighbours in
// the light field (FirstSamples): those in their row and column behind the same lens, and those of
// the same direction behind the next lenses in a row. (Those behind the rows above and below would
// lower the error by 0.4% more behind square lenses, and cost a strip of a frame more rows beside
// its own.)
//
// A neighbour's colour is another estimate of the pixel's light, and so is the mean of the two
// nearest neighbours along an axis, which also holds where the light changes evenly. Their
// difference has two causes: noise, whose square is expected, and that they show other light. The
// latter is told by the mean square of such differences over the pixels around. The more it exceeds
// what noise lets expect, the less an estimate counts.
#ifndef INTEGRAL_LIGHTFIELD_NOISE_FILTER_H
#define INTEGRAL_LIGHTFIELD_NOISE_FILTER_H

#include "integral/lightfield/first_samples.h"
#include "integral/lightfield/four_floats.h"
#include "integral/lightfield/pass_schedule.h"

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace integral {

/// Different threads may filter different blocks.
class NoiseFilter {
public:
    /// Refers to `finished`, which must outlive it: when a block is filtered, the colours there and
    /// around are those of the reconstructed frame (FirstSamples::recolour).
    NoiseFilter(const IntegralCamera& camera, const FirstSamples& finished);

    /// Pixels around over which squares are averaged; the furthest ones that are mixed; and how
    /// many rows away a finished pixel depends on.
    static constexpr int reach_around = 2, reach_along = 4, rows = reach_around + reach_along;

    /// Working memory of one thread.
    struct Scratch;
    struct FreeScratch {
        void operator()(Scratch* scratch) const;
    };
    using ScratchPointer = std::unique_ptr<Scratch, FreeScratch>;
    static ScratchPointer make_scratch();

    /// The squared error that noise is expected to have left in the light of pixel (x, y), in the
    /// encoding of comparison, summed over the colour's components; 0: it is to be left alone.
    using Noise = std::function<float(int x, int y)>;

    /// Finds what is to be added to the colours of a block's pixels, row by row, in the encoding of
    /// comparison. The result lies between the least and the greatest of the pixel and those
    /// neighbours, component by component.
    void filter(const PictureBlock& block, const Noise& noise, Scratch& scratch,
                std::vector<FourFloats>& changes) const;

private:
    struct Pixels;

    void read(const PictureBlock& block, const Noise& noise, Scratch& scratch) const;

    const FirstSamples& finished_;
    std::array<float, 3> apart_; ///< along each axis, the part of a pixel's noise that the mean of
                                 ///< two neighbours does not share
};

} // namespace integral

#endif
