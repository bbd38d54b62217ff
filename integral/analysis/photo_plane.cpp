// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/photo_plane.h"

#include "integral/analysis/scan_colour.h"
#include "integral/base/parallel.h"

#include <algorithm>

namespace integral {

Plane luminance_plane(const Image& picture, int threads)
{
    Plane plane;
    plane.width = picture.width;
    plane.height = picture.height;
    plane.values.resize(std::size_t(picture.width) * picture.height);
    const LinearReader light(picture);
    for_each_row(picture.height, threads, [&](int y) {
        for (int x = 0; x < picture.width; ++x)
            plane.at(x, y) = float(luminance(light(x, y)));
    });
    return plane;
}

Plane reduced(const Plane& plane, int factor)
{
    Plane small;
    small.width = plane.width / factor;
    small.height = plane.height / factor;
    small.values.resize(std::size_t(small.width) * small.height);
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) {
            double sum = 0;
            for (int j = 0; j < factor; ++j)
                for (int i = 0; i < factor; ++i)
                    sum += plane.at(x * factor + i, y * factor + j);
            small.at(x, y) = float(sum / (factor * factor));
        }
    return small;
}

Plane local_mean(const Plane& plane, int reach)
{
    const std::size_t columns = std::size_t(plane.width) + 1;
    std::vector<double> sums(columns * (plane.height + 1)); // of all pixels above and to the left
    for (int y = 0; y < plane.height; ++y) {
        double row = 0;
        for (int x = 0; x < plane.width; ++x) {
            row += plane.at(x, y);
            sums[(y + 1) * columns + x + 1] = sums[y * columns + x + 1] + row;
        }
    }
    Plane mean = plane;
    for (int y = 0; y < plane.height; ++y)
        for (int x = 0; x < plane.width; ++x) {
            const std::size_t left = std::max(0, x - reach),
                              right = std::min(plane.width, x + reach + 1),
                              top = std::max(0, y - reach),
                              bottom = std::min(plane.height, y + reach + 1);
            const double sum = sums[bottom * columns + right] - sums[bottom * columns + left] -
                               sums[top * columns + right] + sums[top * columns + left];
            mean.at(x, y) = float(sum / double((right - left) * (bottom - top)));
        }
    return mean;
}

} // namespace integral
