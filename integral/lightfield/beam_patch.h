// SPDX-License-Identifier: AGPL-3.0-or-later
// Which part of the scene a pixel's beam covers, and which other pixels' beams may cover it too.
//
// A beam fills the cell of its lens and a pixel's span of slopes. So at a depth z it covers a patch
// whose density is, along either axis of the lattice, that of the sum of two evenly distributed
// variables: a lens's width, and a pixel's width as it is seen at that depth.
//
// Behind leaning lines these two widths are not in one direction: a lens is wide across the lines,
// a pixel is wide along the slit in the aperture. So where the pixel's width is the larger one,
// places along the lines are counted from the slit's direction: less `lean` times the place across.
#ifndef INTEGRAL_LIGHTFIELD_BEAM_PATCH_H
#define INTEGRAL_LIGHTFIELD_BEAM_PATCH_H

#include "integral/lightfield/beam_samples.h"
#include "integral/lightfield/eight_floats.h"

#include <cmath>
#include <vector>

namespace integral {

/// A pixel's beam.
class BeamPatch {
public:
    BeamPatch() = default;
    /// `centre`: the pixel's line. `size`: of the part of it that counts, in pixels, right and up.
    /// `furthest`: the greatest depth that it shows on either side of the sheet, mm.
    BeamPatch(const IntegralCamera& camera, const SightSlope& centre, Vec2 size, float furthest);

    /// The two widths of which a patch's density is made, along one axis, in mm at the depth z
    /// (mm): the lens's, cell_at_sheet + cell_slope |z|, and the pixel's, |pixel_at_sheet +
    /// pixel_slope z|.
    struct Axis {
        float cell_at_sheet = 0, cell_slope = 0;
        float pixel_at_sheet = 0, pixel_slope = 0;
        float step_slope = 0; ///< by which the lines of two whole pixels beside each other differ
        /// Other pixels' samples count whose slopes differ from the beam's by up to about
        /// lent_slope, and whose lenses are up to about lent_way (mm) away.
        float lent_slope = 0, lent_way = 0;

        // Number: float or a type of eight floats (eight_floats.h).
        template <class Number> INTEGRAL_INLINE Number cell(Number depth) const
        {
            return eight_of<Number>(cell_at_sheet) +
                   eight_of<Number>(cell_slope) * magnitude(depth);
        }
        /// Negative where the pixel's rays have crossed.
        template <class Number> INTEGRAL_INLINE Number pixel(Number depth) const
        {
            return eight_of<Number>(pixel_at_sheet) + eight_of<Number>(pixel_slope) * depth;
        }
        /// Half the patch's width, mm.
        template <class Number> INTEGRAL_INLINE Number reach(Number depth) const
        {
            return eight_of<Number>(0.5f) * (cell(depth) + magnitude(pixel(depth)));
        }
        /// The square of a place (-1 to 1 in the patch), less the mean of such squares over the
        /// beam at a depth.
        template <class Number>
        INTEGRAL_INLINE Number square_above_mean(Number place, Number depth) const
        {
            const Number lens = cell(depth), own = magnitude(pixel(depth)), both = lens + own;
            return place * place -
                   eight_of<Number>(1.0f / 3) * (lens * lens + own * own) / (both * both);
        }
    };
    /// Across and along the lattice.
    const Axis& axis(int which) const { return axes_[which]; }
    /// What is taken off places and slopes along the lines, for each unit across them.
    float lean() const { return lean_; }
    /// By how much the slopes of the beam's lines differ from the central one's, at most, along
    /// both axes.
    std::array<float, 2> half_slopes() const
    {
        const auto along = [](const Axis& axis) {
            return 0.5f * (std::fabs(axis.pixel_slope) + axis.cell_slope);
        };
        return {along(axes_[0]), along(axes_[1])};
    }

private:
    std::array<Axis, 2> axes_; ///< across and along the lattice
    float lean_ = 0;
};

/// The pixels whose samples a pixel uses: itself, and those of nearly the same direction behind its
/// own lens and behind those around.
class LendingPixels {
public:
    LendingPixels(const Lattice& lattice, const Film& film);

    /// Pixels beside each other that may lend their samples: some of eight.
    struct Found {
        std::ptrdiff_t index;          ///< of the first of the eight, row by row from the top
        unsigned which;                ///< bit k is set: the pixel at index + k may lend
        FirstSamples::StoredLens lens; ///< behind which they are expected; one may be behind
                                       ///< another
        const Eight* parts; ///< the weights of their samples, 0 to 1, which fall with the distance
                            ///< between directions
    };
    /// Working memory of one thread.
    struct Scratch {
        /// Of the steps along both axes: see find_nearness.
        std::array<std::vector<Eight>, 2> nearness;
        std::vector<Found> found; ///< the first `number` of these
        std::size_t number = 0;
        const Found* begin() const { return found.data(); }
        const Found* end() const { return found.data() + number; }
    };

    /// Sets `scratch` to the pixels of the frame whose beams come near the patch of a pixel
    /// behind `own` lens at a depth from `nearest` to `furthest`. It leaves out those that would
    /// hardly count: those at the rim of the range of directions whose patches hardly meet.
    void find(int x, int y, FirstSamples::StoredLens own, const BeamPatch& patch, float nearest,
              float furthest, Scratch& scratch) const;

    /// The greatest distance in rows.
    int rows() const { return rows_; }

private:
    /// Eight steps along one axis: how far the lens (mm) and the direction (pixels) are from the
    /// pixel's own.
    struct EightSteps {
        Eight lens{}, pixels{};
    };
    /// Eight pixels beside each other, behind one lens.
    struct Lenders {
        int x, y;                   ///< the first one, pixels to the right and down
        std::int16_t i, j;          ///< the step to their lens
        std::array<int, 2> steps{}; ///< across and along: indices in steps_
        Eight parts{};              ///< the weights of their samples; 0: not to be used
        Eight nearness{};           ///< falls with the distance between directions
    };
    void add_lens(const Lattice& lattice, const Film& film, int row, LensIndex step);
    int index_of(int axis, const EightSteps& steps);
    template <class Floats>
    void find_nearness(int axis, const BeamPatch& patch, float nearest, float furthest,
                       Scratch& scratch) const;
    template <class Floats>
    void find_with(int x, int y, FirstSamples::StoredLens own, const BeamPatch& patch,
                   float nearest, float furthest, Scratch& scratch) const;
    void find_with_avx2(int x, int y, FirstSamples::StoredLens own, const BeamPatch& patch,
                        float nearest, float furthest, Scratch& scratch) const;

    bool lines_;
    int width_, height_;
    int rows_ = 0;
    std::array<std::vector<Lenders>, 2> lenders_;  ///< from an even and from an odd row of lenses
    std::array<std::vector<EightSteps>, 2> steps_; ///< along both axes
};

} // namespace integral

#endif
