// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/laboratory/lens_shape.h"

#include "integral/base/number_text.h"
#include "integral/optics/lens_model.h"

#include <algorithm>
#include <stdexcept>

namespace integral {

LensShape focused_shape(const LensSheet& sheet, double conic)
{
    return {surface_radius(sheet), conic};
}

double focusing_conic(const LensSheet& sheet) { return -1 / (sheet.ior * sheet.ior); }

SheetRelief::SheetRelief(const LensSheet& sheet, const LensShape& shape)
    : lattice_(sheet), shape_(shape), reach_(cell_circumradius(sheet))
{
    if (!(shape.radius > 0))
        throw std::invalid_argument("a sheet of index 1 has no lenses to make");
    if ((1 + shape.conic) * reach_ * reach_ > shape.radius * shape.radius)
        throw std::invalid_argument(
            "a surface of radius " + with_digits(shape.radius, 4) + " mm and conic " +
            with_digits(shape.conic, 4) + " does not reach the cells' corners, " +
            with_digits(reach_, 4) + " mm from the pole; a thicker sheet has flatter lenses");
}

double SheetRelief::depth_at(double distance) const
{
    const double r = std::min(distance, reach_), radius = shape_.radius;
    const double under = std::max(radius * radius - (1 + shape_.conic) * r * r, 0.0);
    return r * r / (radius + std::sqrt(under));
}

double SheetRelief::depth(Vec2 point) const
{
    return depth_at(lattice_.distance(point, lattice_.nearest(point)));
}

} // namespace integral
