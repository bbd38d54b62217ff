// SPDX-License-Identifier: AGPL-3.0-or-later
// How much of an edge there is at each place of a scan: what the borders between micro-images are
// found by.
#ifndef INTEGRAL_ANALYSIS_EDGE_RESPONSE_H
#define INTEGRAL_ANALYSIS_EDGE_RESPONSE_H

#include "integral/lightfield/image.h"

#include <vector>

namespace integral {

/// Numbers on a raster; pixel (x, y) centred at (x + 1/2, y + 1/2).
struct Plane {
    int width = 0, height = 0;
    std::vector<float> values; ///< row by row from the top
    double mean = 0;           ///< of all of them, where a function says that it sets it

    float at(int x, int y) const { return values[std::size_t(y) * width + x]; }
    float& at(int x, int y) { return values[std::size_t(y) * width + x]; }
};

/// The gradient's length g over all colours, as g / (g + m), m its mean over the surroundings
/// (`reach` pixels each way) and a little of that of the whole: 0 to 1, whatever the light and the
/// contrast, so that a picture's own strong edges count little more than the borders of its
/// micro-images. Each pixel is the mean of `reduction` x `reduction` of the scan's, what is left
/// over at the right and below is left out. reach and reduction > 0.
Plane edge_response(const Image& scan, int reduction, double reach, int threads);

/// Blurred by a Gaussian of this standard deviation, pixels; beyond the edge, as at the edge. Sets
/// the mean.
Plane blurred(const Plane& plane, double deviation, int threads);

/// a - b, of the same size. Sets the mean.
Plane difference(Plane a, const Plane& b);

} // namespace integral

#endif
