// SPDX-License-Identifier: AGPL-3.0-or-later
// Maps of space that keep straight lines straight and the axis of the sheet in place: the image by
// a thin lens (projection.h), and the relief in which a viewer sees a scene (optics.md section 8).
#ifndef INTEGRAL_OPTICS_COLLINEATION_H
#define INTEGRAL_OPTICS_COLLINEATION_H

#include "integral/optics/vec.h"

#include <optional>

namespace integral {

/// A straight line: origin + s direction.
struct Line {
    Vec3 origin, direction;
};

/// The map (x, y, z) -> (lateral x, lateral y, depth z) / w with w = 1 + bend z. It maps the plane
/// z = 0 to itself. Lengths in mm; bend in 1/mm. Default: the identity.
struct Collineation {
    double lateral = 1; ///< not 0
    double depth = 1;   ///< scale of depth at z = 0; 0 maps all points with w > 0 to z = 0
    double bend = 0;
};

/// Image of a point. Empty if w <= 0: the image is infinitely far, or beyond.
inline std::optional<Vec3> image_of(const Collineation& map, Vec3 point)
{
    const double w = 1 + map.bend * point.z;
    if (!(w > 0))
        return std::nullopt;
    return Vec3{map.lateral * point.x / w, map.lateral * point.y / w, map.depth * point.z / w};
}

/// z of the point whose image is at depth z. Empty if no point has an image that deep.
inline std::optional<double> preimage_depth(const Collineation& map, double z)
{
    if (z == 0)
        return 0;
    const double w = map.depth - map.bend * z;
    if (!(w > 0))
        return std::nullopt;
    return z / w;
}

/// Inverse of image_of: the point with this image. Empty where preimage_depth is.
inline std::optional<Vec3> preimage_of(const Collineation& map, Vec3 image)
{
    const auto z = preimage_depth(map, image.z);
    if (!z)
        return std::nullopt;
    const double scale = (1 + map.bend * *z) / map.lateral;
    return Vec3{scale * image.x, scale * image.y, *z};
}

/// Image (origin in z = 0, direction.z = 1) of a line that is not parallel to z = 0. map.depth must
/// not be 0.
inline Line image_of(const Collineation& map, const Line& line)
{
    const double x = line.direction.x / line.direction.z, y = line.direction.y / line.direction.z;
    const Vec3 at{line.origin.x - line.origin.z * x, line.origin.y - line.origin.z * y, 0};
    const double scale = map.lateral / map.depth;
    return {map.lateral * at, {scale * (x - map.bend * at.x), scale * (y - map.bend * at.y), 1}};
}

/// Inverse: the line (origin in z = 0, direction.z = 1) whose image is `line`, which is not
/// parallel to z = 0. If map.depth is 0, all lines through a point of z = 0 have the same preimage.
inline Line preimage_of(const Collineation& map, const Line& line)
{
    const double x = line.direction.x / line.direction.z, y = line.direction.y / line.direction.z;
    const Vec3 at{(line.origin.x - line.origin.z * x) / map.lateral,
                  (line.origin.y - line.origin.z * y) / map.lateral, 0};
    const double scale = map.depth / map.lateral;
    return {at, {scale * x + map.bend * at.x, scale * y + map.bend * at.y, 1}};
}

/// Maps the normal of a plane through `point` to a normal (any length, same side) of the plane's
/// image, for a map with lateral = 1. A normal is a covector: the inverse map multiplies it.
inline Vec3 image_of_normal(const Collineation& map, Vec3 point, Vec3 normal)
{
    return {map.depth * normal.x, map.depth * normal.y, normal.z + map.bend * dot(normal, point)};
}

} // namespace integral

#endif
