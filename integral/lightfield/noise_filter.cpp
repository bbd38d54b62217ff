// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/noise_filter.h"

#include <algorithm>
#include <cmath>

namespace integral {

namespace {

// The part of a pixel's noise that its neighbours do not share, times how much less noise there is
// than the samples' variance lets expect. Most pixels share most of their samples with those beside
// them. Behind a lenticular sheet they share hardly any with those that look along the lines at
// another height. Found by comparing frames of sample scenes of POV-Ray's with converged ones.
constexpr float apart_behind_lenses = 0.25f, apart_across_lines = 0.12f, apart_along_lines = 0.8f;

} // namespace

/// The squares of a pixel's differences from the means of its neighbours along each axis, 0 along
/// an axis on which it has not both neighbours, and what noise lets expect of them.
struct NoiseFilter::Squares {
    FourFloats seen{}, noise{};
    std::uint32_t lens = 0; ///< FirstSamples::number_of
    bool any = false;       ///< whether the pixel is behind a lens
    bool is_noisy = false;
};

struct NoiseFilter::Scratch {
    BlockWindow<Squares> squares;
};

void NoiseFilter::FreeScratch::operator()(Scratch* scratch) const { delete scratch; }

NoiseFilter::ScratchPointer NoiseFilter::make_scratch() { return ScratchPointer(new Scratch); }

NoiseFilter::NoiseFilter(const IntegralCamera& camera, const FirstSamples& finished)
    : finished_(finished)
{
    const Lattice& lattice = camera.optics.lattice();
    const bool lenticular = lattice.arrangement() == Arrangement::lenticular;
    const float usual = lenticular ? apart_across_lines : apart_behind_lenses;
    apart_ = FourFloats{} + usual;
    if (lenticular) {
        const Vec2 along = lattice.along();
        apart_[std::fabs(along.x) > std::fabs(along.y) ? 0 : 1] = apart_along_lines;
    }
}

/// `noise`: that of the pixel. Leaves the lens as it is.
void NoiseFilter::set_squares(int x, int y, float noise, Squares& squares) const
{
    squares.any = true;
    squares.is_noisy = noise > 0;
    finished_.for_each_second_difference(x, y, [&](int axis, FourFloats difference) {
        squares.seen[axis] = sum_of(difference * difference);
        squares.noise[axis] = noise * apart_[axis];
    });
}

/// `around`: of this pixel and those around.
FourFloats NoiseFilter::change(int x, int y, const BlockWindow<Squares>& around) const
{
    const std::uint32_t lens = around.at(x, y).lens;
    FourFloats seen{}, noise{};
    around.for_each_around<reach_around>(x, y, [&](int, int, const Squares& other) {
        if (!other.any || other.lens != lens)
            return;
        seen += other.seen;
        noise += other.noise;
    });
    float weights = 1; // of the pixel itself
    FourFloats change{};
    finished_.for_each_second_difference(x, y, [&](int axis, FourFloats difference) {
        const float own = noise[axis];
        if (!(own > 0))
            return;
        const float weight = own / std::max(own, seen[axis] - own);
        change += weight * difference;
        weights += weight;
    });
    return change / weights;
}

void NoiseFilter::filter(const PictureBlock& block, const Noise& noise, Scratch& scratch,
                         std::vector<FourFloats>& changes) const
{
    BlockWindow<Squares>& window = scratch.squares;
    fill_behind_lenses(window, block, reach_around, finished_, [&](int x, int y, Squares& squares) {
        set_squares(x, y, noise(x, y), squares);
    });
    changes.clear();
    for (int y = block.top; y <= block.bottom; ++y)
        for (int x = block.left; x <= block.right; ++x)
            changes.push_back(window.at(x, y).is_noisy ? change(x, y, window) : FourFloats{});
}

} // namespace integral
