// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/optics/aperture.h"

#include <algorithm>

namespace integral {
namespace {

/// Extent along one axis (x or y) of a regular hexagon whose opposite sides are `pitch` apart:
/// twice the coordinate of its farthest corner. `across`, `along`: the components, on the axis, of
/// the unit vectors Lattice::across() and along(). In the coordinates of these two vectors, the
/// corners are at (pitch/2, pitch/sqrt(12)), (0, pitch/sqrt(3)) and their mirror images.
double hexagon_extent(double pitch, double across, double along)
{
    const double side_corner = std::fabs(across) + std::fabs(along) / std::sqrt(3.0);
    const double end_corner = 2 / std::sqrt(3.0) * std::fabs(along);
    return pitch * std::max(side_corner, end_corner);
}

} // namespace

bool within_ellipse(const Aperture& aperture, Vec2 point)
{
    const auto part = [](double coordinate, double half) {
        return std::isinf(half) || coordinate == 0 ? 0.0 : coordinate / half;
    };
    const double u = part(point.x, 0.5 * aperture.width * inclusive_edge),
                 v = part(point.y, 0.5 * aperture.height * inclusive_edge);
    return u * u + v * v <= 1;
}

bool slit_is_horizontal(const LensSheet& sheet) { return std::fabs(sheet.slant) <= 45; }

bool lenses_lie_across(const LensSheet& sheet)
{
    return sheet.arrangement == Arrangement::lenticular && !slit_is_horizontal(sheet);
}

double extent_along_slit(const LensSheet& sheet, Vec2 extent)
{
    return slit_is_horizontal(sheet) ? extent.x : extent.y;
}

double extent_across_slit(const LensSheet& sheet, Vec2 extent)
{
    return slit_is_horizontal(sheet) ? extent.y : extent.x;
}

double micro_image_width(const LensSheet& sheet, double distance, double width)
{
    if (!(width > 0))
        return 0;
    const double m = (sheet.ior - 1) * (sheet.ior + 1);
    return 2 * sheet.thickness / std::hypot(2 * sheet.ior * (distance / width), std::sqrt(m));
}

std::optional<double> filling_width(const LensSheet& sheet, double distance, double cell)
{
    // 2 d s / sqrt(1 - s^2) with s^2 = n^2 h^2/(h^2 + t^2) is 2 d n h / sqrt(t^2 - m h^2).
    const double half = 0.5 * cell;
    const double root = std::sqrt((sheet.ior - 1) * (sheet.ior + 1)) * half;
    const double clear = (sheet.thickness - root) * (sheet.thickness + root);
    if (!(clear > 0))
        return std::nullopt;
    return 2 * distance * sheet.ior * half / std::sqrt(clear);
}

Vec2 cell_extent(const LensSheet& sheet)
{
    const Lattice lattice(sheet);
    const double cosine = std::fabs(lattice.across().x), sine = std::fabs(lattice.across().y);
    switch (sheet.arrangement) {
    case Arrangement::lenticular:
        return slit_is_horizontal(sheet) ? Vec2{sheet.pitch / cosine, 0}
                                         : Vec2{0, sheet.pitch / sine};
    case Arrangement::square: return {sheet.pitch * (cosine + sine), sheet.pitch * (cosine + sine)};
    case Arrangement::hexagonal: break;
    }
    return {hexagon_extent(sheet.pitch, lattice.across().x, lattice.along().x),
            hexagon_extent(sheet.pitch, lattice.across().y, lattice.along().y)};
}

std::optional<Aperture> filling_aperture(const LensSheet& sheet, double distance)
{
    const Vec2 cell = cell_extent(sheet);
    const auto width = filling_width(sheet, distance, cell.x);
    const auto height = filling_width(sheet, distance, cell.y);
    if (!width || !height)
        return std::nullopt;
    return Aperture{distance, *width, *height, ApertureShape::rectangle};
}

Vec2 viewing_zone(const LensSheet& sheet, const Aperture& aperture)
{
    const Vec2 cell = cell_extent(sheet);
    const auto extent = [&](double captured, double filled) {
        return std::min(
            captured,
            filling_width(sheet, aperture.distance, filled).value_or(2 * aperture.distance));
    };
    return {extent(aperture.width, cell.x), extent(aperture.height, cell.y)};
}

} // namespace integral
