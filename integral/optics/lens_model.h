// SPDX-License-Identifier: AGPL-3.0-or-later
// The lens models, and the sample points of a film point's light on a lens.
#ifndef INTEGRAL_OPTICS_LENS_MODEL_H
#define INTEGRAL_OPTICS_LENS_MODEL_H

#include "integral/optics/lens_sheet.h"

#include <vector>

namespace integral {

/// Path of a film point's light at its lens (optics.md section 3).
enum class LensModel {
    pinhole,          ///< straight through the pole, as if n were 1 (3-8)
    extended_pinhole, ///< refracted at the pole, by the sheet plane (3-9)
    /// Refracted by the curved surface, at the pole and at marginal points (thesis 3.4.7).
    hybrid,
    /// Refracted by the curved surface, at any points of the lens's cell (thesis 3.4.3).
    full
};

/// Whether a model's rays are refracted at the curved surface, point by point. In the other models
/// a film point's light leaves as one parallel beam.
inline bool refracts_at_surface(LensModel model)
{
    return model == LensModel::hybrid || model == LensModel::full;
}

/// The sheet with the model's ior: 1 for pinhole, the sheet's own for the others.
LensSheet modelled_sheet(LensSheet sheet, LensModel model);

/// Radius (mm) of the smallest circle around a lens's cell; lenticular: p/2, half its width.
double cell_circumradius(const LensSheet& sheet);

/// Whether the curved surface extends to the edge of the cell: n > 1 and R >= the cell's
/// circumradius. The models hybrid and full need it.
bool has_surface(const LensSheet& sheet);

/// A point of a lens through which light leaves it.
struct LensPoint {
    /// mm from the pole, in the sheet frame; lenticular: from the axis, perpendicular to it.
    Vec2 offset;
    /// Lenticular only: coordinate across the slit, mm, at which the light passes the aperture
    /// plane: y (for a vertical slit, x). eta in optics.md section 3.
    double slit = 0;
};

/// The point of a lens's cell at unit-square coordinates (u, v), u and v in [0, 1): an
/// area-preserving map onto the cell that takes (1/2, 1/2) to the pole. Lenticular: u goes across
/// the lens, v over a slit of height `slit_height` (mm).
LensPoint cell_point(const Lattice& lattice, Vec2 unit, double slit_height = 0);

/// A point of the lens or its neighbours at unit-square coordinates (u, v), distributed by a tent:
/// the density falls from the pole to 0 at one pitch across the lens and, unless it is lenticular,
/// at one row spacing along it. The sum of all lenses' densities is constant. Lenticular: v as in
/// cell_point.
LensPoint tent_point(const Lattice& lattice, Vec2 unit, double slit_height = 0);

/// u in [0, 1) -> a coordinate in (-1/2, 3/2) whose density is a tent about 1/2; area-preserving.
double tent_coordinate(double u);

/// One of hybrid's points of a lens and its weight. The pole comes first; the weights add up to 1.
/// There are 3 points (lenticular) or 5, with the weights I(0) = 1 (pole) and I(1) = cos(atan 4)
/// (others), normalised.
struct WeightedLensPoint {
    LensPoint point;
    double weight = 1;
};
std::vector<WeightedLensPoint> hybrid_points(const Lattice& lattice);

} // namespace integral

#endif
