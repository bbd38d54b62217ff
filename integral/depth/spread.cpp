// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/spread.h"

#include "integral/depth/texture.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

constexpr int passes = 3;
constexpr double even_colour = 0.05; ///< sum of differences in R, G and B over which the mean
                                     ///< reaches e times less far
constexpr float unsure = 0.05f, sure = 0.25f; ///< confidences
constexpr float no_texture = 0.006f, some_texture = 0.016f;
/// How far a value is on the way from `low` to `high`: 0 to 1.
float part_of(float value, float low, float high)
{
    return std::clamp((value - low) / (high - low), 0.0f, 1.0f);
}

/// The distances between neighbouring pixels, made longer by their difference of colour, in pixels.
std::vector<float> distances(const ViewSet& views, double reach, std::size_t step)
{
    std::vector<float> far(views.pixels(), 1);
    for (std::size_t i = 0; i + step < far.size(); ++i) {
        float difference = 0;
        for (const auto& channel : views.colours)
            difference += std::fabs(channel[i + step] - channel[i]);
        far[i] += float(reach / even_colour) * difference;
    }
    return far;
}

/// Two sums along a line of `count` pixels, `step` apart, each carried on to the next pixel with
/// the weight of their distance, there and back.
void filter_line(std::vector<float>& value, std::vector<float>& weight,
                 const std::vector<float>& carried, std::size_t first, std::size_t step, int count)
{
    const auto carry = [&](std::size_t from, std::size_t to, float part) {
        value[to] += part * (value[from] - value[to]);
        weight[to] += part * (weight[from] - weight[to]);
    };
    for (int k = 1; k < count; ++k) {
        const std::size_t at = first + step * std::size_t(k);
        carry(at - step, at, carried[at - step]);
    }
    for (int k = count - 1; k > 0; --k) {
        const std::size_t at = first + step * std::size_t(k);
        carry(at, at - step, carried[at - step]);
    }
}

} // namespace

void spread_from_sure_pixels(const ViewSet& views, double reach, int threads,
                             std::vector<float>& disparity, const std::vector<float>& confidence)
{
    const std::size_t width = std::size_t(views.width);
    std::vector<float> value(views.pixels()), weight(views.pixels());
    for (std::size_t i = 0; i < value.size(); ++i) {
        weight[i] = confidence[i] * confidence[i] + 1e-6f;
        if (!views.is_lit(i))
            weight[i] = 0;
        value[i] = weight[i] > 0 ? weight[i] * disparity[i] : 0;
    }
    const auto across = distances(views, reach, 1), down = distances(views, reach, width);
    std::vector<float> carried(views.pixels());
    for (int pass = 0; pass < passes; ++pass) {
        const double spread = reach * std::sqrt(3.0) * std::pow(2.0, passes - pass - 1) /
                              std::sqrt(std::pow(4.0, passes) - 1);
        const float slope = float(-std::sqrt(2.0) / spread);
        for_each_row(views.height, threads, [&](int y) {
            for (std::size_t i = width * y; i < width * (y + 1); ++i)
                carried[i] = std::exp(slope * across[i]);
            filter_line(value, weight, carried, width * y, 1, views.width);
            for (std::size_t i = width * y; i < width * (y + 1); ++i)
                carried[i] = std::exp(slope * down[i]);
        });
        for_each_row(views.width, threads, [&](int x) {
            filter_line(value, weight, carried, std::size_t(x), width, views.height);
        });
    }
    const Texture texture(views);
    for_each_row(views.height, threads, [&](int y) {
        for (int x = 0; x < views.width; ++x) {
            const std::size_t i = width * std::size_t(y) + std::size_t(x);
            const float trust = std::max(
                part_of(confidence[i], unsure, sure),
                part_of(float(texture.at(x, y)), no_texture, some_texture));
            if (views.is_lit(i) && weight[i] > 0)
                disparity[i] += (1 - trust) * (value[i] / weight[i] - disparity[i]);
        }
    });
}

} // namespace integral
