// SPDX-License-Identifier: AGPL-3.0-or-later
// Which part of the scene a pixel's beam covers, and which other pixels' beams may cover it too.
//
// A beam fills the cell of its lens and a pixel's span of slopes. So at a depth z it covers a patch
// whose density is, along either axis of the lattice, that of the sum of two evenly distributed
// variables: a lens's width, and a pixel's width as it is seen at that depth.
#ifndef INTEGRAL_LIGHTFIELD_BEAM_PATCH_H
#define INTEGRAL_LIGHTFIELD_BEAM_PATCH_H

#include "integral/lightfield/beam_samples.h"

#include <vector>

namespace integral {

/// A pixel's beam.
class BeamPatch {
public:
    BeamPatch() = default;
    /// `centre`: the pixel's line.
    BeamPatch(const IntegralCamera& camera, const SightSlope& centre);

    /// The two widths of which a patch's density is made, along one axis, in mm at the depth z
    /// (mm): the lens's, cell_at_sheet + cell_slope |z|, and the pixel's, |pixel_at_sheet +
    /// pixel_slope z|.
    struct Axis {
        float cell_at_sheet = 0, cell_slope = 0;
        float pixel_at_sheet = 0, pixel_slope = 0;
        /// Other pixels' samples count whose slopes differ from the beam's by up to about
        /// lent_slope, and whose lenses are up to about lent_way (mm) away.
        float lent_slope = 0, lent_way = 0;

        float cell(float depth) const { return cell_at_sheet + cell_slope * std::fabs(depth); }
        /// Negative where the pixel's rays have crossed.
        float pixel(float depth) const { return pixel_at_sheet + pixel_slope * depth; }
        /// Half the patch's width, mm.
        float reach(float depth) const { return 0.5f * (cell(depth) + std::fabs(pixel(depth))); }
    };
    /// Across and along the lattice.
    const Axis& axis(int which) const { return axes_[which]; }

    /// Half the patch's width along an axis, mm.
    float reach(int which, float depth) const { return axes_[which].reach(depth); }

private:
    std::array<Axis, 2> axes_; ///< across and along the lattice
};

/// The pixels whose samples a pixel uses: itself, and those of nearly the same direction behind its
/// own lens and behind those around.
class LendingPixels {
public:
    LendingPixels(const Lattice& lattice, const Film& film);

    /// Working memory of one thread.
    struct Scratch {
        std::array<std::vector<char>, 2> may_meet; ///< by `steps`, for both axes
    };

    /// Calls visit(x, y, lens, part) for the pixels, which may be outside the frame or behind other
    /// lenses than `lens`, the one that is expected. `part`: the weight of the pixel's
    /// samples, 0 to 1, which falls with the distance between directions. It leaves out those whose
    /// beams do not meet the patch of a pixel behind `own` lens at any depth from `nearest` to
    /// `furthest`.
    template <class Visit>
    void for_each(int x, int y, FirstSamples::StoredLens own, const BeamPatch& patch, float nearest,
                  float furthest, Scratch& scratch, Visit visit) const;

    /// The greatest distance in rows.
    int rows() const { return rows_; }

private:
    /// Along one axis: how far the lens (mm) and the direction (pixels) are from the pixel's own.
    struct Step {
        float lens, pixels;
    };
    struct Lender {
        int x, y;                   ///< pixels to the right and down
        std::int16_t i, j;          ///< the step to its lens
        std::array<int, 2> steps{}; ///< across and along
        float part = 1;             ///< the weight of its samples
    };
    void add_pixels(const Lattice& lattice, const Film& film, int row, LensIndex step);
    int index_of(int axis, double lens, double pixels);
    void find_meeting(int axis, const BeamPatch& patch, float nearest, float furthest,
                      Scratch& scratch) const;

    bool lines_;
    int rows_ = 0;
    std::array<std::vector<Lender>, 2> lenders_; ///< from an even and from an odd row of lenses
    std::array<std::vector<Step>, 2> steps_;     ///< along both axes
};

template <class Visit>
void LendingPixels::for_each(int x, int y, FirstSamples::StoredLens own, const BeamPatch& patch,
                             float nearest, float furthest, Scratch& scratch, Visit visit) const
{
    for (int axis = 0; axis < 2; ++axis) {
        scratch.may_meet[axis].resize(steps_[axis].size());
        find_meeting(axis, patch, nearest, furthest, scratch);
    }
    for (const Lender& lender : lenders_[own[1] & 1])
        if (scratch.may_meet[0][lender.steps[0]] && scratch.may_meet[1][lender.steps[1]])
            visit(x + lender.x, y + lender.y,
                  FirstSamples::StoredLens{std::uint16_t(own[0] + lender.i),
                                           std::uint16_t(own[1] + lender.j)},
                  lender.part);
}

} // namespace integral

#endif
