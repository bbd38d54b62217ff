// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/optics/lens_surface.h"

namespace integral {

SheetSurface::SheetSurface(const LensSheet& sheet)
    : lattice_(sheet),
      medium_(sheet.thickness, sheet.ior),
      radius_(surface_radius(sheet)),
      reach_(cell_circumradius(sheet)),
      deepest_(0)
{
    if (const auto corner = tangent_plane(radius_, reach_))
        deepest_ = corner->height;
}

/// Entry of the line into one lens's ball (cylinder), which lies entirely at z >= 0.
std::optional<SurfacePoint> SheetSurface::intersection(LensIndex lens, Vec2 point, Vec2 slope) const
{
    Vec2 offset = point - lattice_.pole(lens);
    if (lattice_.arrangement() == Arrangement::lenticular) {
        const Vec2 across = lattice_.across();
        offset = dot(offset, across) * across;
        slope = dot(slope, across) * across;
    }
    // The lesser root z of |offset + z slope|^2 + (z - R)^2 = R^2.
    const double half = radius_ - dot(offset, slope), square = dot(offset, offset);
    const double root2 = half * half - (1 + dot(slope, slope)) * square;
    if (!(half > 0 && root2 >= 0))
        return std::nullopt;
    const double depth = square / (half + std::sqrt(root2));
    return SurfacePoint{depth, offset + depth * slope};
}

/// The nearest intersection with any lens, no deeper than the surface's deepest points. A line
/// nearly parallel to the sheet passes many lenses before it is that deep: it is cut into pieces at
/// most a pitch long. Each is tested against the few lenses near it, until a piece meets one.
std::optional<SurfacePoint> SheetSurface::first_intersection(Vec2 point, Vec2 slope) const
{
    const double aside = deepest_ * length(slope);
    constexpr double most = 1000; // pitches; lines nearer to parallel see no film
    if (!(aside < most * lattice_.pitch()))
        return std::nullopt;
    const int pieces = 1 + int(aside / lattice_.pitch());
    for (int piece = 0; piece < pieces; ++piece) {
        std::optional<SurfacePoint> first;
        const Vec2 middle = point + (deepest_ * (piece + 0.5) / pieces) * slope;
        lattice_.for_each_within(middle, reach_ + 0.5 * aside / pieces, [&](LensIndex lens) {
            const auto met = intersection(lens, point, slope);
            if (met && (!first || met->depth < first->depth))
                first = met;
        });
        if (first && (first->depth <= deepest_ * (piece + 1) / pieces || piece + 1 == pieces))
            return first;
    }
    return std::nullopt;
}

std::optional<Vec2> SheetSurface::film_point_seen(Vec2 point, Vec2 slope, double film_gap) const
{
    const auto met = first_intersection(point, slope);
    if (!met)
        return std::nullopt;
    const auto plane = tangent_plane(radius_, length(met->offset));
    if (!plane)
        return std::nullopt;
    const Vec3 to_eye{-slope.x, -slope.y, -1};
    const Vec3 direction = (1 / length(to_eye)) * to_eye;
    const Vec2 b = plane->v > 0 ? (1 / plane->v) * met->offset : Vec2{1, 0}, a{-b.y, b.x};
    const Vec2 lateral{direction.x, direction.y};
    const auto way = way_refracted_into(medium_, *plane,
                                        {dot(b, lateral), dot(a, lateral), direction.z});
    if (!way)
        return std::nullopt;
    const double stretch = 1 + film_gap / (medium_.t - plane->height);
    return point + met->depth * slope - (stretch * way->x) * b - (stretch * way->y) * a;
}

} // namespace integral
