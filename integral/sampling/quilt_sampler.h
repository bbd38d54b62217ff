// SPDX-License-Identifier: AGPL-3.0-or-later
// Chooses the rays of a quilt: a picture of perspective views, each from its own eye, all with the
// sheet as their image plane.
#ifndef INTEGRAL_SAMPLING_QUILT_SAMPLER_H
#define INTEGRAL_SAMPLING_QUILT_SAMPLER_H

#include "integral/frame/view_grid.h"
#include "integral/optics/camera.h"

#include <optional>

namespace integral {

/// Immutable, and shared by all threads.
class QuiltSampler {
public:
    /// A quilt of width x height pixels that shows a camera's whole sheet. The eyes are spread over
    /// the viewing zone as by integral views --eyes, in the order of ViewGrid (see directions_of).
    /// Throws std::invalid_argument, with a sentence for the user, if there are more views than
    /// pixels in either direction.
    QuiltSampler(const IntegralCamera& camera, ViewGrid tiles, int width, int height);

    /// The ray that a place in the picture shows: from a point of the sheet to the view's eye.
    /// Takes continuous pixel coordinates from the top left. Nothing in the columns at the right
    /// and the rows at the top that are left over if the grid does not divide the picture's size.
    std::optional<BeamRay> ray(Vec2 pixel) const;

    /// The record about the views for the picture's metadata.
    QuiltRecord record() const { return {tiles_, std::nullopt, eyes_}; }

private:
    ViewGrid tiles_, directions_;
    EyeGrid eyes_;
    Vec2 window_;                              ///< size of the sheet, mm
    int tile_width_, tile_height_, left_over_; ///< pixels; left over: at the top
};

} // namespace integral

#endif
