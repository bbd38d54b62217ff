// SPDX-License-Identifier: AGPL-3.0-or-later
// The lenses of a projection system (thesis 5.5, figures 5-10 and 5-12): one ideal thin lens before
// the sheet, or an array of them side by side, which projects the sheet's replayed light as a
// magnified aerial image towards the viewer.
#ifndef INTEGRAL_OPTICS_PROJECTION_H
#define INTEGRAL_OPTICS_PROJECTION_H

#include "integral/optics/collineation.h"

#include <algorithm>

namespace integral {

/// Lengths in mm. The image of the sheet's plane is upside down, image_distance() before the lens.
/// The image frame is the sheet frame moved there: origin in the image's middle, +z away from the
/// viewer, so that the lens is at z = image_distance() and the sheet behind it.
struct ProjectionLens {
    double focal_length = 0;   ///< > 0
    double distance = 0;       ///< from the sheet to the lens, > focal_length
    double viewer = 0;         ///< from the sheet's image to the viewer's eye, > 0
    int columns = 1, rows = 1; ///< macro-lenses across and down, all with the same rectangular
                               ///< outline
    Vec2 extent = {};          ///< width and height of the whole array; any for a single lens

    double magnification() const { return focal_length / (distance - focal_length); }
    double image_distance() const { return distance * magnification(); }

    /// Maps the sheet frame to the image frame, for one lens with its middle on the axis: the thin
    /// lens's equation.
    Collineation image() const
    {
        const double m = magnification();
        return {-m, m * m, 1 / (distance - focal_length)};
    }

    /// Distance from the sheet to the lens's image of the viewer's eye: less than `distance`.
    double eye_image_distance() const { return distance - eye_image_beside(); }
    /// Size of that image divided by the eye's size; the image is upside down.
    double eye_scale() const { return eye_image_beside() / (image_distance() + viewer); }

    /// The middle of the macro-lens at a point of the lenses' plane.
    Vec2 middle_at(Vec2 lens_point) const
    {
        return {middle(lens_point.x, extent.x, columns), middle(lens_point.y, extent.y, rows)};
    }

private:
    double eye_image_beside() const ///< distance of that image from the lens, towards the sheet
    {
        const double eye = image_distance() + viewer;
        return focal_length * eye / (eye - focal_length);
    }
    static double middle(double at, double whole, int count)
    {
        if (count == 1)
            return 0;
        const double width = whole / count;
        const double number = std::clamp(std::floor(at / width + 0.5 * count), 0.0, count - 1.0);
        return (number + 0.5 - 0.5 * count) * width;
    }
};

/// The line, in the image frame and directed into the scene, of the light that leaves the sheet's
/// plane at `sheet_point` (sheet frame) and meets the lens at `lens_point`. The line's
/// origin is the image of the sheet point by the lens at `lens_point`, where all light of the sheet
/// point through that lens meets, in the image's plane. direction.z = 1.
inline Line projected(const ProjectionLens& lens, Vec2 sheet_point, Vec2 lens_point)
{
    const Vec2 middle = lens.middle_at(lens_point), from = sheet_point - middle,
               slope = (1 / lens.distance) * (sheet_point - lens_point);
    Line line = image_of(lens.image(), Line{{from.x, from.y, 0}, {slope.x, slope.y, 1}});
    line.origin = line.origin + Vec3{middle.x, middle.y, 0};
    return line;
}

/// Inverse: the sheet and lens points of a line in the image frame (direction.z not 0).
struct ProjectedFrom {
    Vec2 sheet_point, lens_point;
};
inline ProjectedFrom projected_from(const ProjectionLens& lens, const Line& line)
{
    const Vec3 meets = line.origin + ((lens.image_distance() - line.origin.z) / line.direction.z) *
                                         line.direction;
    const Vec2 lens_point{meets.x, meets.y}, middle = lens.middle_at(lens_point);
    const Vec3 off_axis{middle.x, middle.y, 0};
    const Line on_sheet = preimage_of(lens.image(), Line{line.origin - off_axis, line.direction});
    return {middle + Vec2{on_sheet.origin.x, on_sheet.origin.y}, lens_point};
}

} // namespace integral

#endif
