// SPDX-License-Identifier: AGPL-3.0-or-later
#include "bench/pictures.h"

#include <algorithm>
#include <cmath>

namespace integral::bench {

Image shrunk(const Image& image, int block)
{
    Image result = make_image<std::uint16_t>(image.width / block, image.height / block, 3, image.encoding);
    const LinearReader read(image);
    const float weight = 1.0f / float(block * block);
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x) {
            Color sum;
            for (int j = 0; j < block; ++j)
                for (int i = 0; i < block; ++i) {
                    const Color c = read(x * block + i, y * block + j);
                    sum = {sum.r + c.r * weight, sum.g + c.g * weight, sum.b + c.b * weight, 1};
                }
            store_linear(result, x, y, sum);
        }
    return result;
}

void ColorDifferences::add(const Color& a, const Color& b)
{
    for (const double difference : {double(a.r) - b.r, double(a.g) - b.g, double(a.b) - b.b})
        squares_ += difference * difference;
    values_ += 3;
}

double ColorDifferences::rms() const { return std::sqrt(squares_ / double(std::max(values_, 1LL))); }

} // namespace integral::bench
