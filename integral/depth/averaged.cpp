// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/averaged.h"

#include "integral/base/parallel.h"

#include <algorithm>

namespace integral {

int reduction(const Image& picture, int width)
{
    return std::clamp(picture.width / std::max(1, width), 1,
                      std::min(picture.width, picture.height));
}

Image averaged(const Image& picture, int factor, int threads)
{
    if (factor == 1)
        return picture;
    Image small = blank_like(picture, picture.width / factor, picture.height / factor);
    const LinearReader light(picture);
    const float part = 1 / (float(factor) * float(factor));
    for_each_row(small.height, threads, [&](int y) {
        for (int x = 0; x < small.width; ++x) {
            Colour sum{0, 0, 0, 0};
            for (int k = 0; k < factor * factor; ++k) {
                const Colour c = light(x * factor + k % factor, y * factor + k / factor);
                sum.r += part * c.r;
                sum.g += part * c.g;
                sum.b += part * c.b;
                sum.a += part * c.a;
            }
            store_linear(small, x, y, sum);
        }
    });
    return small;
}

} // namespace integral
