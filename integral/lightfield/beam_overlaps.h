// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds the pixels whose beams overlap with a pixel's beam in the scene, and how much they do.
//
// At a depth z a beam covers a patch that is as wide as a lens at the sheet and grows by a pixel's
// span of slopes. How far the patches of two pixels are apart follows, paraxially, from the step
// between their lenses and from the way between the pixels.
#ifndef INTEGRAL_LIGHTFIELD_BEAM_OVERLAPS_H
#define INTEGRAL_LIGHTFIELD_BEAM_OVERLAPS_H

#include "integral/lightfield/first_samples.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace integral {

class BeamOverlaps {
public:
    /// Refers to `camera` and to `first`, whose lenses and depths it uses; both must outlive it.
    /// `reach`: the greatest distance in rows of the pixels that are looked at.
    BeamOverlaps(const IntegralCamera& camera, const FirstSamples& first, int reach);

    /// A pixel, which counts row by row from the top, and how much its beam overlaps: 0 to 1, by a
    /// narrow and by a wide measure.
    struct Overlap {
        std::uint32_t pixel;
        float narrow, wide;
    };
    /// Working memory of one thread, which holds what was found last.
    class Found {
    public:
        const Overlap* begin() const { return overlaps_.data(); }
        const Overlap* end() const { return overlaps_.data() + number_; }

    private:
        friend class BeamOverlaps;
        std::vector<Overlap> overlaps_;
        std::vector<std::array<float, 2>> columns_;
        std::size_t number_ = 0;
    };

    /// Finds the pixels, itself included, whose beams overlap with that of pixel (x, y), which must
    /// not be empty.
    void find(int x, int y, Found& found) const;

private:
    static constexpr int depths = 2; ///< the least and the greatest around a pixel
    using AtDepths = std::array<float, depths>;

    /// A neighbouring lens, or the pixel's own.
    struct Lens {
        int i, j;      ///< the step to it in the lattice
        Vec2 step;     ///< mm, along (for a lenticular sheet: across) the film's axes
        int right, up; ///< the same in pixels; behind lines, of the way across
    };
    /// How far patches move along one axis, in patches: for each mm to the lens, and for each pixel
    /// of the way to the pixel.
    struct Axis {
        AtDepths by_step, by_pixel;
        AtDepths pixels; ///< 1/by_pixel; 0 where the way to the pixel moves nothing
    };
    struct Axes {
        Axis x, y;             ///< behind a lenticular sheet, x is the one across it
        int right = 0, up = 0; ///< pixels to the middle of the lens's pixels (not behind lines)
    };
    /// Whole numbers, `last` included.
    struct Range {
        int first, last;
    };

    static AtDepths start(const Axis& axis, double step);
    Axes axes(int x, int y) const;
    Axis axis(const AtDepths& move, double pixel, double pace) const;
    Range range(const Axis& axis, const AtDepths& start, int middle, int reach) const;
    void find_behind_lens(int x, int y, const Axes& axes, const Lens& lens,
                          FirstSamples::StoredLens other, Found& found) const;
    void find_behind_line(int x, int y, const Axis& axis, const Lens& lens,
                          FirstSamples::StoredLens other, Found& found) const;

    /// Lines of lenses: the way along the film's axis that crosses them.
    struct Lines {
        bool upright;
        double pixel; ///< a pixel's extent across the lines (mm)
        double pace;  ///< mm across the lines for a pixel of the way
        float lean; ///< pixels along the other axis for each of the way that leads straight across
        /// What a pixel to the right and one down go along the lines, in pixels, and across them,
        /// in paces.
        std::array<float, 2> along, across;
    };

    const IntegralCamera& camera_;
    const FirstSamples& first_;
    int width_, height_;
    int reach_;
    int pixels_across_; ///< the greatest number of pixels across a lens
    int pixels_beside_; ///< from the middle of a lens's pixels to the furthest, with a margin
    std::optional<Lines> lines_;
    std::array<std::vector<Lens>, 2> lenses_; ///< from an even and from an odd row of lenses
};

} // namespace integral

#endif
