// SPDX-License-Identifier: AGPL-3.0-or-later
// How a lens is modelled: what light of one film point leaves it, and through which points of it.
#ifndef INTEGRAL_OPTICS_LENS_MODEL_H
#define INTEGRAL_OPTICS_LENS_MODEL_H

#include "integral/optics/lens_sheet.h"

#include <vector>

namespace integral {

/// What a film point's light does at its lens (optics.md section 3).
enum class LensModel {
    pinhole,          ///< goes straight through the pole, as if n were 1 (3-8)
    extended_pinhole, ///< is refracted at the pole, by the sheet plane (3-9)
    hybrid,           ///< is refracted by the curved surface, at the pole and at marginal points
                      ///< (thesis 3.4.7)
    full ///< is refracted by the curved surface, at any points of the lens's cell (thesis 3.4.3)
};

/// Whether a model's rays are refracted at the curved surface, point by point. The others send a
/// film point's light out as one parallel beam.
inline bool refracts_at_surface(LensModel model)
{
    return model == LensModel::hybrid || model == LensModel::full;
}

/// The sheet whose ior the model computes by: 1 for pinhole, the sheet's own for every other.
LensSheet modelled_sheet(LensSheet sheet, LensModel model);

/// Radius (mm) of the smallest circle that holds a lens's cell; lenticular: p/2, half its width.
double cell_circumradius(const LensSheet& sheet);

/// Whether the spherical surface reaches the edge of the cell: n > 1 and R >= the cell's
/// circumradius. hybrid and full need it.
bool has_surface(const LensSheet& sheet);

/// A point of a lens through which light leaves it.
struct LensPoint {
    Vec2 offset; ///< mm from the pole, in the sheet frame; lenticular: from the axis, perpendicular
                 ///< to it
    double slit = 0; ///< mm; lenticular: the height (its sign that of y, or of x for a vertical
                     ///< slit) at which the light passes the slit's plane, eta in optics.md section
                     ///< 3; else unused
};

/// The point of a lens's cell at unit-square coordinates (u, v), u and v in [0, 1): an
/// area-preserving map onto the cell that takes (1/2, 1/2) to the pole. Lenticular: u goes across
/// the lens, v over a slit of height `slit_height` (mm).
LensPoint cell_point(const Lattice& lattice, Vec2 unit, double slit_height = 0);

/// A point of the lens and its neighbours at unit-square coordinates (u, v): of density a tent,
/// that is 0 from one pitch away on, across the lens and, unless it is lenticular, along it
/// (hexagonal: from one row spacing away on). The sum over all lenses is the same everywhere.
/// Lenticular: v as in cell_point.
LensPoint tent_point(const Lattice& lattice, Vec2 unit, double slit_height = 0);

/// u in [0, 1) -> a coordinate in (-1/2, 3/2) whose density is a tent about 1/2; area-preserving.
double tent_coordinate(double u);

/// hybrid's points of a lens, the pole first, and their weights, which add up to 1: 3 points
/// (lenticular) or 5, at I(0) = 1 and I(1) = cos(atan 4), normalised.
struct WeightedLensPoint {
    LensPoint point;
    double weight = 1;
};
std::vector<WeightedLensPoint> hybrid_points(const Lattice& lattice);

} // namespace integral

#endif
