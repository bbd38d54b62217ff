// SPDX-License-Identifier: AGPL-3.0-or-later
// Measures how strong an edge is at each pixel of a scan, to find the borders between micro-images.
#ifndef INTEGRAL_ANALYSIS_EDGE_RESPONSE_H
#define INTEGRAL_ANALYSIS_EDGE_RESPONSE_H

#include "integral/frame/image.h"
#include "integral/optics/vec.h"

#include <optional>
#include <vector>

namespace integral {

/// A raster of numbers; pixel (x, y) is centred at (x + 1/2, y + 1/2).
struct Plane {
    int width = 0, height = 0;
    std::vector<float> values; ///< row by row from the top
    double mean = 0;           ///< of all values; set only by functions that say so

    float at(int x, int y) const { return values[std::size_t(y) * width + x]; }
    float& at(int x, int y) { return values[std::size_t(y) * width + x]; }
};

/// The strength g / (g + m) of the edge at each pixel: g is the length of the gradient over all
/// colours, m is the mean of g over the neighbourhood (`reach` pixels each way) plus a tenth of the
/// mean of g over the whole scan. The strength is 0 to 1 in any light and contrast, so that strong
/// edges of the picture count little more than the borders of micro-images. Each pixel is the mean
/// of `reduction` x `reduction` scan pixels; incomplete blocks at the right and bottom are left
/// out. reach and reduction > 0. With `across`, a unit vector in the scan's pixels, g is the
/// gradient along that direction only.
Plane edge_response(const Image& scan, int reduction, double reach, int threads,
                    std::optional<Vec2> across = std::nullopt);

/// A plane blurred by a Gaussian of this standard deviation (pixels); the plane's outermost values
/// continue beyond its sides. Sets the mean.
Plane blurred(const Plane& plane, double deviation, int threads);

/// a - b, planes of the same size. Sets the mean.
Plane difference(Plane a, const Plane& b);

} // namespace integral

#endif
