// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/optics/lens_model.h"

namespace integral {

LensSheet modelled_sheet(LensSheet sheet, LensModel model)
{
    if (model == LensModel::pinhole)
        sheet.ior = 1;
    return sheet;
}

double cell_circumradius(const LensSheet& sheet)
{
    switch (sheet.arrangement) {
    case Arrangement::square: return sheet.pitch * std::sqrt(0.5);
    case Arrangement::hexagonal: return sheet.pitch / std::sqrt(3.0);
    case Arrangement::lenticular: break;
    }
    return 0.5 * sheet.pitch;
}

bool has_surface(const LensSheet& sheet)
{
    return sheet.ior > 1 && surface_radius(sheet) >= cell_circumradius(sheet);
}

LensPoint cell_point(const Lattice& lattice, Vec2 unit, double slit_height)
{
    const double u = unit.x - 0.5, v = unit.y - 0.5, p = lattice.pitch();
    if (lattice.arrangement() == Arrangement::lenticular)
        return {(u * p) * lattice.across(), v * slit_height};
    if (lattice.arrangement() == Arrangement::square)
        return {(u * p) * lattice.across() + (v * p) * lattice.along()};

    // (u, v) is a point of the lattice's parallelogram. Moving it by the lattice vector that brings
    // it nearest to the pole gives a point of the hexagon, and keeps areas.
    const double row = std::sqrt(0.75);
    const Vec2 point{u + 0.5 * v, row * v}; // in pitches, along the rows and across them
    const Vec2 vectors[] = {{1, 0}, {-1, 0}, {0.5, row}, {-0.5, -row}};
    Vec2 nearest = point;
    for (const Vec2 vector : vectors)
        if (const Vec2 moved = point - vector; dot(moved, moved) < dot(nearest, nearest))
            nearest = moved;
    return {(nearest.x * p) * lattice.across() + (nearest.y * p) * lattice.along()};
}

double tent_coordinate(double u)
{
    return u < 0.5 ? std::sqrt(2 * u) - 0.5 : 1.5 - std::sqrt(2 * (1 - u));
}

LensPoint tent_point(const Lattice& lattice, Vec2 unit, double slit_height)
{
    if (lattice.arrangement() == Arrangement::lenticular)
        return cell_point(lattice, {tent_coordinate(unit.x), unit.y}, slit_height);
    return {((tent_coordinate(unit.x) - 0.5) * lattice.pitch()) * lattice.across() +
            ((tent_coordinate(unit.y) - 0.5) * lattice.row_spacing()) * lattice.along()};
}

std::vector<WeightedLensPoint> hybrid_points(const Lattice& lattice)
{
    const bool lenticular = lattice.arrangement() == Arrangement::lenticular;
    const double marginal = std::cos(std::atan(4.0)), sum = 1 + (lenticular ? 2 : 4) * marginal;
    const double half = 0.5 * lattice.pitch();
    std::vector<WeightedLensPoint> points = {{{}, 1 / sum}};
    for (const double side : {-half, half})
        points.push_back({{side * lattice.across()}, marginal / sum});
    if (!lenticular)
        for (const double side : {-half, half})
            points.push_back({{side * lattice.along()}, marginal / sum});
    return points;
}

} // namespace integral
