// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/frame/linear_writer.h"

#include <cmath>
#include <limits>

namespace integral {

LinearWriter::LinearWriter(Image& image) : image_(image)
{
    if (sample_bits(image) != 8 || image.channels != 3)
        return;
    Image pixel = blank_like(image, 1, 1);
    const auto stored = [&](float light) {
        store_linear(pixel, 0, 0, {light, light, light, 1});
        return int(std::get<std::vector<std::uint8_t>>(pixel.samples)[0]);
    };
    if (stored(1) != 255)
        return;
    first_light_.push_back(0);
    for (int sample = 1; sample <= 255; ++sample) {
        float below = first_light_.back(), at = 1; // stored as less, and as `sample` or more
        if (stored(below) >= sample)               // a steep encoding passes over samples
            at = below;
        while (true) {
            const float middle = below + (at - below) / 2;
            if (!(middle > below && middle < at))
                break;
            (stored(middle) < sample ? below : at) = middle;
        }
        first_light_.push_back(at);
    }
    first_light_.push_back(std::numeric_limits<float>::infinity());
    int sample = 0;
    for (int k = 0; k < steps; ++k) {
        while (float(k) / steps >= first_light_[std::size_t(sample) + 1])
            ++sample;
        start_.push_back(std::uint8_t(sample));
    }
}

} // namespace integral
