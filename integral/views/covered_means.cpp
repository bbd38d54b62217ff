// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/views/covered_means.h"

#include "integral/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

/// Source pixels that one new pixel covers, along one side.
struct Covered {
    int first = 0;
    std::vector<float> weights; ///< of the pixels from `first` on; their sum is 1
};

std::vector<Covered> covered_by(int old_side, int new_side)
{
    std::vector<Covered> all(new_side);
    const double scale = double(old_side) / new_side;
    for (int k = 0; k < new_side; ++k) {
        const double from = k * scale, to = std::min((k + 1) * scale, double(old_side));
        Covered& c = all[k];
        c.first = std::min(int(from), old_side - 1);
        for (int at = c.first; at < old_side && (at < to || c.weights.empty()); ++at)
            c.weights.push_back(
                float((std::min(to, at + 1.0) - std::max(from, double(at))) / (to - from)));
    }
    return all;
}

Colour finite(Colour c)
{
    const auto f = [](float v) { return std::isfinite(v) ? v : 0; };
    return {f(c.r), f(c.g), f(c.b), share_of(c.a)};
}

} // namespace

int pixels_of_step(int pixels, double length, double step)
{
    return int(std::clamp(std::ceil(length / step), 1.0, double(pixels)));
}

Image covered_means(const Image& picture, int width, int height, int threads)
{
    Image small = make_image<float>(width, height, 4, Encoding{Encoding::Kind::linear});
    small.premultiplied = true;
    const LinearReader light(picture);
    const std::vector<Covered> across = covered_by(picture.width, width),
                               down = covered_by(picture.height, height);
    for_each_row(height, threads, [&](int y) {
        std::vector<Colour> row(picture.width, Colour{0, 0, 0, 0});
        for (std::size_t j = 0; j < down[y].weights.size(); ++j)
            for (int x = 0; x < picture.width; ++x)
                add(row[x], down[y].weights[j], finite(light(x, down[y].first + int(j))));
        for (int x = 0; x < width; ++x) {
            Colour mean{0, 0, 0, 0};
            for (std::size_t i = 0; i < across[x].weights.size(); ++i)
                add(mean, across[x].weights[i], row[across[x].first + int(i)]);
            store_linear(small, x, y, mean);
        }
    });
    return small;
}

} // namespace integral
