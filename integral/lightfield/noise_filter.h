// SPDX-License-Identifier: AGPL-3.0-or-later
// Lowers the noise that a reconstructed frame has left, by mixing pixels with their neighbours in
// the light field (FirstSamples): the next pixels behind the same lens, and the pixels of the same
// direction behind the next lenses in a row. (Those behind the rows above and below would lower the
// error by 0.7% more, and cost a strip of a frame more rows beside its own.)
//
// The mean of a pixel's two neighbours along an axis is another estimate of the pixel's light.
// Their difference has two causes: the pixel's noise, whose square is expected, and the error of
// the other estimate, most of all where the light is curved. So that error is told by the mean
// square of such differences over the pixels around. Each estimate counts by the inverse of its
// squared error.
#ifndef INTEGRAL_LIGHTFIELD_NOISE_FILTER_H
#define INTEGRAL_LIGHTFIELD_NOISE_FILTER_H

#include "integral/lightfield/block_window.h"
#include "integral/lightfield/four_floats.h"

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

    /// Pixels around over which squares are averaged.
    static constexpr int reach_around = 2;

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
    /// comparison. The result lies between the pixel and the means of its neighbours.
    void filter(const PictureBlock& block, const Noise& noise, Scratch& scratch,
                std::vector<FourFloats>& changes) const;

private:
    struct Squares;

    void set_squares(int x, int y, float noise, Squares& squares) const;
    FourFloats change(int x, int y, const BlockWindow<Squares>& around) const;

    const FirstSamples& finished_;
    FourFloats apart_; ///< along each axis, the part of a pixel's noise that its neighbours do not
                       ///< share
};

} // namespace integral

#endif
