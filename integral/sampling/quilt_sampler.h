// SPDX-License-Identifier: AGPL-3.0-or-later
// Chooses the rays of a quilt: a picture of perspective views, each from its own eye, all with the
// sheet as their image plane.
#ifndef INTEGRAL_SAMPLING_QUILT_SAMPLER_H
#define INTEGRAL_SAMPLING_QUILT_SAMPLER_H

#include "integral/frame/quilt_geometry.h"
#include "integral/optics/camera.h"
#include "integral/sampling/pixel_sampler.h"
#include "integral/sampling/sample_points.h"

#include <cstdint>
#include <optional>

namespace integral {

/// Immutable, and shared by all threads.
class QuiltSampler {
public:
    /// A quilt of width x height pixels that shows a camera's whole sheet. The eyes are spread over
    /// the viewing zone as by integral views --eyes, in the order of ViewGrid (see directions_of).
    /// `seed`: of the samples. Throws std::invalid_argument, with a sentence for the user, if there
    /// are more views than pixels in either direction.
    QuiltSampler(const IntegralCamera& camera, ViewGrid tiles, int width, int height,
                 std::uint64_t seed = 0);

    /// The ray that a place in the picture shows: from a point of the sheet to the view's eye.
    /// Takes continuous pixel coordinates from the top left. Nothing in the columns at the right
    /// and the rows at the top that are left over if the grid does not divide the picture's size.
    std::optional<BeamRay> ray(Vec2 pixel) const;

    /// Sample `index` of the area of pixel (x, y); nothing where ray() gives nothing. The first
    /// samples of a view's pixels are well distributed over the view. The samples of one pixel are
    /// well distributed over the pixel. Samples of different views are independent. `same_pattern`:
    /// all pixels have the same pattern instead.
    std::optional<BeamRay> sample(int x, int y, bool same_pattern, std::uint32_t index) const;

    /// Ray `index` of a `set` of rays at random points of the area of pixel (x, y). The rays of a
    /// set are well distributed; different sets are independent.
    std::optional<BeamRay> reference(int x, int y, std::uint64_t set, std::uint32_t index) const;

    /// Column (from the left) and row (from the bottom) of the tile that contains pixel (x, y);
    /// nothing in the parts that are left over.
    std::optional<LensIndex> tile(int x, int y) const;

    /// The counts of pixel (x, y); its tile takes the place of a lens. Pixels that are left over
    /// count as outside the aperture.
    PixelOutcome outcome(int x, int y) const;

    QuiltGeometry geometry() const;

    /// A lattice whose axes are horizontal and vertical.
    const Lattice& upright() const { return upright_; }

    /// The record about the views for the picture's metadata.
    QuiltRecord record() const { return {tiles_, std::nullopt, eyes_}; }

private:
    ViewGrid tiles_, directions_;
    EyeGrid eyes_;
    Vec2 window_;                              ///< size of the sheet, mm
    int width_, height_;                       ///< pixels
    int tile_width_, tile_height_, left_over_; ///< pixels; left over: at the top
    std::uint64_t seed_;
    Lattice upright_{LensSheet{}};

    std::optional<BeamRay> ray_within(int x, int y, const UnitPoint& unit) const
    {
        return ray({x + unit[0], y + unit[1]});
    }
};

} // namespace integral

#endif
