// SPDX-License-Identifier: AGPL-3.0-or-later
// Computes which part of the scene a pixel's beam covers, and finds the pixels whose beams may
// cover the same part.
//
// A beam's rays pass through all points of its lens's cell, with all slopes that reach its pixel.
// At a depth z these rays cover a footprint. Along either axis of the lattice, a ray's place in it
// is the sum of two uniformly distributed variables: one spans the lens's width, the other the
// pixel's width as projected to that depth. The footprint's density is the density of that sum.
//
// If lenticular lenses (here: lines) are slanted, the two widths lie in different directions: a
// lens is wide across the lines, a pixel is wide along the slit in the aperture (optics/slit.h). If
// the pixel's width matters more, coordinates along the lines are measured from the slit's
// direction: `lean` times the coordinate across the lines is subtracted from them.
#ifndef INTEGRAL_RECONSTRUCTION_BEAM_FOOTPRINT_H
#define INTEGRAL_RECONSTRUCTION_BEAM_FOOTPRINT_H

#include "integral/base/eight_floats.h"
#include "integral/reconstruction/beam_samples.h"

#include <cmath>
#include <vector>

namespace integral {

/// Footprint of a pixel's beam as a function of depth.
class BeamFootprint {
public:
    BeamFootprint() = default;
    /// `centre`: the central ray. `size`: width and height of the part of the pixel that is behind
    /// its lens (clipped_pixel.h), in pixels. `furthest`: the largest distance from the sheet, on
    /// either side, of a surface that the pixel shows, mm.
    BeamFootprint(const IntegralCamera& camera, const LightFieldRay& centre, Vec2 size,
                  float furthest);

    /// Footprint of a pixel of a quilt: all its rays meet in the eye, so that the lens's width is
    /// 0. `pixel`: width and height of the pixel at the sheet, mm. `distance`: of the eye from the
    /// sheet, mm. `furthest_eye`: the largest distance of another eye whose samples are used,
    /// horizontally and vertically, mm. `next_eye`: the distance of the next eye, mm.
    static BeamFootprint of_view(Vec2 pixel, double distance, Vec2 furthest_eye, double next_eye);

    /// The two widths that determine the footprint's density along one axis, in mm at the depth z
    /// (mm): the lens's, cell_at_sheet + cell_slope |z|, and the pixel's, |pixel_at_sheet +
    /// pixel_slope z|.
    struct Axis {
        float cell_at_sheet = 0, cell_slope = 0;
        float pixel_at_sheet = 0, pixel_slope = 0;
        float step_slope = 0; ///< slope difference between two adjacent pixels' central rays
        /// Samples of other pixels count if their slopes differ from the central ray's by up to
        /// about max_slope_offset, and if their lenses are up to about max_lens_distance (mm) away.
        float max_slope_offset = 0, max_lens_distance = 0;

        // Number: float or a type of eight floats (eight_floats.h).
        template <class Number> INTEGRAL_INLINE Number cell(Number depth) const
        {
            return broadcast<Number>(cell_at_sheet) + broadcast<Number>(cell_slope) * abs(depth);
        }
        /// The pixel's width, mm; negative at depths beyond the one where the pixel's rays cross.
        template <class Number> INTEGRAL_INLINE Number pixel(Number depth) const
        {
            return broadcast<Number>(pixel_at_sheet) + broadcast<Number>(pixel_slope) * depth;
        }
        /// Half the footprint's width, mm.
        template <class Number> INTEGRAL_INLINE Number reach(Number depth) const
        {
            return broadcast<Number>(0.5f) * (cell(depth) + abs(pixel(depth)));
        }
        /// The square of `place` (-1 to 1 in the footprint) minus the mean of this square over the
        /// beam's rays at the depth.
        template <class Number>
        INTEGRAL_INLINE Number square_above_mean(Number place, Number depth) const
        {
            const Number lens = cell(depth), own = abs(pixel(depth)), both = lens + own;
            return place * place -
                   broadcast<Number>(1.0f / 3) * (lens * lens + own * own) / (both * both);
        }
    };
    /// The axis across (0) or along (1) the lattice.
    const Axis& axis(int which) const { return axes_[which]; }
    /// Divergence of the rays of the nearest beams, per mm, as a fraction of the footprint's width.
    float divergence() const { return divergence_; }
    /// Widening of the beam per mm of distance from the sheet, as a fraction of the lens's width; 0
    /// for a quilt's pixels, whose beams hold the rays of one eye.
    float widening() const { return widening_; }
    /// Depths of surfaces are within +-furthest_depth(), mm (BeamSamples).
    float furthest_depth() const { return furthest_depth_; }
    /// lean() times a place (slope) across the lines is subtracted from the one along the lines.
    float lean() const { return lean_; }
    /// The largest slope difference between the beam's rays and the central one, along both axes.
    std::array<float, 2> half_slopes() const
    {
        const auto along = [](const Axis& axis) {
            return 0.5f * (std::fabs(axis.pixel_slope) + axis.cell_slope);
        };
        return {along(axes_[0]), along(axes_[1])};
    }

private:
    std::array<Axis, 2> axes_; ///< across and along the lattice
    float lean_ = 0, divergence_ = 0, widening_ = 0;
    float furthest_depth_ = furthest_depth_of_frames;
};

/// Finds the pixels whose samples a pixel uses: the pixel itself, and pixels of nearly the same
/// direction behind its own lens and the lenses around it.
class ReuseNeighbourhood {
public:
    ReuseNeighbourhood(const Lattice& lattice, const Film& film);

    /// Eight adjacent pixels of a row, and which of them may be used.
    struct Found {
        std::ptrdiff_t index;             ///< index in the frame of the first of the eight
        unsigned which;                   ///< bit k is set: the pixel at index + k may be used
        LightFieldImage::StoredLens lens; ///< expected lens of the eight; some may be
                                          ///< behind another
        const Eight* parts; ///< weights of the eight pixels' samples, 0 to 1; they fall with the
                            ///< angle between directions
    };
    /// Working memory of one thread.
    struct Scratch {
        /// Nearness of the steps along both axes: see find_nearness.
        std::array<std::vector<Eight>, 2> nearness;
        std::vector<double> parts; ///< see ViewReuse::find_in
        std::vector<Found> found;  ///< only the first `number` are valid
        std::size_t number = 0;
        const Found* begin() const { return found.data(); }
        const Found* end() const { return found.data() + number; }
    };

    /// Sets `scratch` to the pixels whose footprints overlap `patch`, the footprint of pixel (x, y)
    /// behind the lens `own`, at some depth from `nearest` to `furthest` (mm). Leaves out pixels
    /// that would hardly count: their directions differ much, and their footprints hardly overlap.
    void find(int x, int y, LightFieldImage::StoredLens own, const BeamFootprint& patch,
              float nearest, float furthest, Scratch& scratch) const;

    /// The greatest distance, in rows, between a pixel and a pixel whose samples it uses.
    int rows() const { return rows_; }

private:
    /// Offsets of eight pixels from the pixel that uses them, along one axis: of the lens (mm) and
    /// of the direction (pixels).
    struct EightSteps {
        Eight lens{}, pixels{};
    };
    /// Eight adjacent pixels of a row, behind one lens, relative to the pixel that uses them
    /// (user).
    struct Lenders {
        int x, y;                   ///< offset of the first one from the user, pixels
        std::int16_t i, j;          ///< their lens's indices minus the user's
        std::array<int, 2> steps{}; ///< across and along: indices in steps_
        Eight parts{};              ///< weights of their samples; 0: the pixel is not used
        Eight nearness{};           ///< square roots of `parts`
    };
    void add_lens(const Lattice& lattice, const Film& film, int row, LensIndex step);
    int index_of(int axis, const EightSteps& steps);
    template <class Floats>
    void find_nearness(int axis, const BeamFootprint& patch, float nearest, float furthest,
                       Scratch& scratch) const;
    template <class Floats>
    void find_with(int x, int y, LightFieldImage::StoredLens own, const BeamFootprint& patch,
                   float nearest, float furthest, Scratch& scratch) const;
    void find_with_avx2(int x, int y, LightFieldImage::StoredLens own, const BeamFootprint& patch,
                        float nearest, float furthest, Scratch& scratch) const;

    bool lines_;
    int width_, height_;
    int rows_ = 0;
    std::array<std::vector<Lenders>, 2> lenders_;  ///< for lenses in even and in odd rows
    std::array<std::vector<EightSteps>, 2> steps_; ///< along both axes
};

} // namespace integral

#endif
