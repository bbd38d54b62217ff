// SPDX-License-Identifier: AGPL-3.0-or-later
// The relief of a lens sheet that is to be made: the depth of its surface at every point.
#ifndef INTEGRAL_LABORATORY_LENS_SHAPE_H
#define INTEGRAL_LABORATORY_LENS_SHAPE_H

#include "integral/optics/lens_sheet.h"

namespace integral {

/// A surface of revolution (lenticular: of translation) of curvature 1/radius at its pole:
/// z = r^2/(R + sqrt(R^2 - (1 + conic) r^2)). conic 0 is a sphere.
struct LensShape {
    double radius = 0; ///< R, mm; > 0
    double conic = 0;
};

/// The shape with its paraxial focus on the film, spherical or with another conic.
LensShape focused_shape(const LensSheet& sheet, double conic);

/// The conic, -1/n^2, of the ellipsoid that brings all light along the axis to one point of the
/// film.
double focusing_conic(const LensSheet& sheet);

/// The relief of a whole sheet of lenses, each within its own cell (full fill).
class SheetRelief {
public:
    /// Throws std::invalid_argument where the surface does not reach the cells' corners.
    SheetRelief(const LensSheet& sheet, const LensShape& shape);

    /// Depth (mm) of the surface below the poles at a point of the sheet frame, 0 to deepest().
    double depth(Vec2 point) const;
    /// The same at a distance (mm) from a pole or axis, at most reach().
    double depth_at(double distance) const;
    double deepest() const { return depth_at(reach_); }
    /// mm from a pole to its cell's farthest corner (lenticular: half the pitch).
    double reach() const { return reach_; }

private:
    Lattice lattice_;
    LensShape shape_;
    double reach_;
};

} // namespace integral

#endif
