// SPDX-License-Identifier: AGPL-3.0-or-later
// The lines of sight of several neighbouring pixels, worked out side by side. One by one a pixel's
// ray is a chain of some fifteen square roots and quotients, each of which waits for the one
// before; in a vector's lanes eight pixels wait together.
#ifndef INTEGRAL_OPTICS_PIXEL_RUN_H
#define INTEGRAL_OPTICS_PIXEL_RUN_H

#include "integral/optics/camera.h"

#include <array>

namespace integral {

/// Eight pixels of a row, from the left.
struct PixelRun {
    static constexpr int pixels = 8;
    /// Whether a lens shows the pixel's centre to the aperture, beyond doubt; whether none does.
    /// Where both are false nothing is said of the pixel: several lenses may come near to showing
    /// it, or it is so steep that rounding matters.
    std::array<bool, pixels> given = {}, empty = {};
    std::array<bool, pixels> searched = {}; ///< of the given: it is not the nearest lens
    std::array<LensIndex, pixels> lens;     ///< of the given
    std::array<SightLine, pixels> line; ///< of the given: sight_line of the pole ray, bit for bit
};

/// Works out the runs of a camera. Immutable; refers to nothing.
class PixelRuns {
public:
    explicit PixelRuns(const IntegralCamera& camera);

    /// Whether the camera's pixels can be had so: square and lenticular sheets, a rectangular
    /// aperture, `automatic` or `closest`, no pseudoscopic capture. Whether a pixel is more than
    /// its pole ray is not asked.
    bool possible() const { return possible_; }

    /// The pixels whose centres are at `centre`, one to its right, and so on, in pixels from the
    /// film's top left corner.
    void work_out(Vec2 centre, PixelRun& run) const;

private:
    struct Lanes {
        double at[PixelRun::pixels];
        double& operator[](int k) { return at[k]; }
        double operator[](int k) const { return at[k]; }
    };
    struct PoleRays;
    struct Rivals;
    void compare_lenses(LensMapping mapping);
    void guess_lenses(Vec2 centre, PoleRays& rays) const;
    void follow(PoleRays& rays) const;
    void find_rivals(const PoleRays& rays, Rivals& rivals) const;
    void settle(PoleRays& rays, PixelRun& run) const;

    Lattice lattice_;
    bool possible_;
    bool lenticular_, slit_horizontal_, at_aperture_, limited_, guesses_, nearest_gets_through_;
    Vec2 film_centre_, pixel_pitch_, across_, along_, offset_, edge_;
    double pitch_, row_spacing_, farthest_, alone_, beyond_, bend_;
    Vec2 columns_at_aperture_, rows_at_aperture_;     ///< the lattice's directions there
    double column_, row_, diagonal_, other_diagonal_; ///< see Rivals
    double n_, t_, m_, root_m_, distance_;
    double slit_distance_;
    Vec2 slit_axis_, slit_across_, slit_normal_;
    Placement placement_;
    double front_,
        seen_; ///< mm before the sheet where lines start; mm that they are seen, if limited
};

} // namespace integral

#endif
