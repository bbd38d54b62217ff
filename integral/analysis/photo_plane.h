// SPDX-License-Identifier: AGPL-3.0-or-later
// A photograph's light as a raster of numbers, and its values between pixels.
#ifndef INTEGRAL_ANALYSIS_PHOTO_PLANE_H
#define INTEGRAL_ANALYSIS_PHOTO_PLANE_H

#include "integral/analysis/edge_response.h"

namespace integral {

/// Linear luminance of a picture. The mean is not set.
Plane luminance_plane(const Image& picture, int threads);

/// Means of `factor` x `factor` pixels; incomplete blocks at the right and bottom are left out.
Plane reduced(const Plane& plane, int factor);

/// Mean over the square of 2 reach + 1 pixels around each pixel, as far as it lies in the plane.
Plane local_mean(const Plane& plane, int reach);

/// Whether `value_at` is defined at a point.
inline bool is_inside(const Plane& plane, Vec2 pixel)
{
    return pixel.x >= 1 && pixel.y >= 1 && pixel.x < plane.width - 1 && pixel.y < plane.height - 1;
}

/// Value between the pixels' centres, by bilinear interpolation. The point must be inside.
inline double value_at(const Plane& plane, Vec2 pixel)
{
    const double x = pixel.x - 0.5, y = pixel.y - 0.5;
    const int i = int(x), j = int(y);
    const double u = x - i, v = y - j;
    return (1 - v) * ((1 - u) * plane.at(i, j) + u * plane.at(i + 1, j)) +
           v * ((1 - u) * plane.at(i, j + 1) + u * plane.at(i + 1, j + 1));
}

} // namespace integral

#endif
