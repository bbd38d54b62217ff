// SPDX-License-Identifier: AGPL-3.0-or-later
// The lens of a projection system (thesis 5.5, figure 5-12): an ideal thin lens before the sheet,
// which projects what the sheet replays as a magnified aerial image towards the viewer.
#ifndef INTEGRAL_OPTICS_PROJECTION_H
#define INTEGRAL_OPTICS_PROJECTION_H

#include "integral/optics/vec.h"

namespace integral {

/// Lengths in mm. The image of the sheet's plane is upside down, image_distance() before the lens.
/// The image frame is the sheet frame moved there: origin in the image's middle, +z away from the
/// viewer, so that the lens is at z = image_distance() and the sheet behind it.
struct ProjectionLens {
    double focal_length = 0; ///< > 0
    double distance = 0;     ///< from the sheet to the lens, > focal_length
    double viewer = 0;       ///< from the sheet's image to the viewer's eye, > 0

    double magnification() const { return focal_length / (distance - focal_length); }
    double image_distance() const { return distance * magnification(); }
};

/// A straight line: origin + s direction.
struct Line {
    Vec3 origin, direction;
};

/// The line in the image frame, into the scene, along which light travels that leaves the sheet
/// (sheet frame) through `sheet_point` in its plane and meets the lens at `lens_point`: the lens
/// brings all light of a sheet's point together in its image. Origin: in the plane of the image;
/// direction.z = 1.
inline Line projected(const ProjectionLens& lens, Vec2 sheet_point, Vec2 lens_point)
{
    const Vec2 image = -lens.magnification() * sheet_point;
    const Vec2 slope = (1 / lens.image_distance()) * (lens_point - image);
    return {{image.x, image.y, 0}, {slope.x, slope.y, 1}};
}

/// Inverse: where a line in the image frame (direction.z not 0) comes from.
struct ProjectedFrom {
    Vec2 sheet_point, lens_point;
};
inline ProjectedFrom projected_from(const ProjectionLens& lens, const Line& line)
{
    const Vec2 slope{line.direction.x / line.direction.z, line.direction.y / line.direction.z};
    const Vec2 image = Vec2{line.origin.x, line.origin.y} + -line.origin.z * slope;
    return {(-1 / lens.magnification()) * image, image + lens.image_distance() * slope};
}

} // namespace integral

#endif
