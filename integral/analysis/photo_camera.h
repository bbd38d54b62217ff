// SPDX-License-Identifier: AGPL-3.0-or-later
// The camera that photographed a flat page: a pinhole with distortion.
//
// Page frame: mm; x and y as in the sheet frame; z is the height above the print, towards the
// camera. Photo pixels are continuous: the origin is the top left corner of the top left pixel, and
// y points downwards.
#ifndef INTEGRAL_ANALYSIS_PHOTO_CAMERA_H
#define INTEGRAL_ANALYSIS_PHOTO_CAMERA_H

#include "integral/optics/vec.h"

#include <array>
#include <vector>

namespace integral {

struct PhotoCamera {
    Vec3 right, down, forward; ///< unit vectors of the page frame
    Vec3 place;                ///< of the pinhole, page frame
    double focal = 1;          ///< pixels
    Vec2 middle;               ///< principal point, pixels
    /// A point r = (x, y) focal lengths from the principal point appears at
    /// r (1 + k1 r^2 + k2 r^4) + r^2 t + 2 (t r) r: radial distortion, and tangential distortion of
    /// lenses that are not quite centred.
    double k1 = 0, k2 = 0;
    Vec2 tangential; ///< t
};

/// The photo point that shows a page point. The point must be in front of the camera.
Vec2 photo_from_page(const PhotoCamera& camera, Vec3 point);

/// Unit vector, in the page frame, from the camera through a photo point.
Vec3 direction_from_photo(const PhotoCamera& camera, Vec2 pixel);

/// The camera turned by a small rotation vector (radians, page frame).
PhotoCamera turned(PhotoCamera camera, Vec3 by);

/// The camera without distortion that sees four points of the print at four photo points, whose
/// picture has `size` pixels. Chooses the focal length that fits best.
/// Corresponding points have the same index.
PhotoCamera camera_from_four(const std::array<Vec2, 4>& page, const std::array<Vec2, 4>& photo,
                             Vec2 size);

} // namespace integral

#endif
