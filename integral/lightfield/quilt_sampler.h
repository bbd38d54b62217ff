// SPDX-License-Identifier: AGPL-3.0-or-later
// Chooses the rays of a quilt: a picture of perspective views, each from an eye of its own, all
// with the sheet as their image plane.
#ifndef INTEGRAL_LIGHTFIELD_QUILT_SAMPLER_H
#define INTEGRAL_LIGHTFIELD_QUILT_SAMPLER_H

#include "integral/lightfield/view_grid.h"
#include "integral/optics/camera.h"

#include <optional>

namespace integral {

/// Immutable, and shared by all threads.
class QuiltSampler {
public:
    /// A quilt of width x height pixels of what a camera's eyes see of its whole sheet: eyes spread
    /// over the viewing zone as integral views --eyes spreads them, in the order of ViewGrid (see
    /// directions_of). Throws std::invalid_argument, with a sentence for the user, where there are
    /// more views than pixels either way.
    QuiltSampler(const IntegralCamera& camera, ViewGrid tiles, int width, int height);

    /// What a place in the picture shows: the ray from there on the sheet to the view's eye.
    /// Continuous pixel coordinates from the top left. Nothing for the pixels that are left over
    /// at the right and at the top where the grid does not divide the picture.
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
