// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/spread.h"

#include "integral/depth/plane_filter.h"
#include "integral/depth/texture.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

// Shading counts less than edges: highlights move over a surface as if they lay far behind it.
constexpr float no_edge = 0.008f, clear_edge = 0.03f;       ///< texture of pixels that give depth
constexpr float least_confidence = 0.1f;                    ///< of pixels that give depth
constexpr float no_texture = 0.006f, some_texture = 0.016f; ///< of pixels that retain their depth
constexpr int least_size = 128;      ///< of views in which only edges give depth, pixels
constexpr float much_farther = 0.1f; ///< an edge farther by this disparity counts e times more
constexpr float about_same = 0.3f;   ///< disparity by which close edges may be nearer than far ones
constexpr float few_edges = 0.002f;  ///< mean weight at which close edges count as much as far ones
constexpr double slow_change = 0.02; ///< of a colour, from pixel to pixel, within a surface

/// Position of a value between `low` (0) and `high` (1), clamped.
float part_of(float value, float low, float high)
{
    return std::clamp((value - low) / (high - low), 0.0f, 1.0f);
}

/// The texture around each pixel, within `reach` pixels.
std::vector<float> textures(const ViewSet& views, int reach, int threads)
{
    const Texture texture(views);
    std::vector<float> values(views.pixels());
    for_each_row(views.height, threads, [&](int y) {
        float* row = values.data() + std::size_t(y) * std::size_t(views.width);
        for (int x = 0; x < views.width; ++x)
            row[x] = float(texture.at(x, y, reach));
    });
    return values;
}

/// Weight of each pixel as a source of depth for others, by texture and confidence.
std::vector<float> weights(const ViewSet& views, int threads, const std::vector<float>& confidence)
{
    std::vector<float> weight = textures(views, 3, threads);
    for (std::size_t i = 0; i < weight.size(); ++i) {
        const float part = std::max(0.0f, confidence[i] - least_confidence) *
                           part_of(weight[i], no_edge, clear_edge);
        weight[i] = views.is_lit(i) ? part * part : 0;
    }
    return weight;
}

/// The weights, reduced the more the nearer a pixel is.
std::vector<float> farthest_first(const std::vector<float>& weight,
                                  const std::vector<float>& disparity)
{
    constexpr float most = 60; // so that no product is too small for a float
    float least = HUGE_VALF;
    for (std::size_t i = 0; i < weight.size(); ++i)
        if (weight[i] > 0)
            least = std::min(least, disparity[i]);
    std::vector<float> to(weight.size());
    for (std::size_t i = 0; i < weight.size(); ++i)
        if (weight[i] > 0)
            to[i] = weight[i] * std::exp(-std::min(most, (disparity[i] - least) / much_farther));
    return to;
}

/// The disparity of each pixel's surroundings, from the edges in them.
std::vector<float> told_by_edges(const ViewSet& views, double reach, int threads,
                                 const std::vector<float>& disparity,
                                 const std::vector<float>& confidence)
{
    const std::vector<float> weight = weights(views, threads, confidence),
                             farther = farthest_first(weight, disparity);
    const PlaneFilter wide(views, {10 * reach, 0.01, slow_change}, threads),
        close(views, {0.35 * reach, 0.02, slow_change}, threads);
    std::vector<float> told = wide.means(disparity, farther).value;
    const std::vector<float> near = close.planes(disparity, farther).value,
                             number = close.means(disparity, weight).weight;
    for (std::size_t i = 0; i < told.size(); ++i) {
        const float nearer = std::max(0.0f, (near[i] - told[i]) / about_same);
        if (std::isfinite(near[i]) && std::isfinite(told[i]))
            told[i] += number[i] / (number[i] + few_edges) * std::exp(-nearer * nearer) *
                       (near[i] - told[i]);
    }
    return told;
}

/// The disparity of each pixel's surroundings, from all pixels in them, weighted by confidence.
std::vector<float> told_by_all(const ViewSet& views, double reach, int threads,
                               const std::vector<float>& disparity,
                               const std::vector<float>& confidence)
{
    std::vector<float> weight(confidence.size());
    for (std::size_t i = 0; i < weight.size(); ++i)
        weight[i] = views.is_lit(i) ? confidence[i] * confidence[i] + 1e-6f : 0;
    return PlaneFilter(views, {reach, 0.05, 0}, threads).means(disparity, weight).value;
}

} // namespace

void propagate_confident(const ViewSet& views, double reach, int threads,
                         std::vector<float>& disparity, const std::vector<float>& confidence)
{
    const bool is_large = std::min(views.width, views.height) >= least_size;
    const std::vector<float> told = (is_large ? told_by_edges : told_by_all)(views, reach, threads,
                                                                             disparity, confidence),
                             texture = textures(views, 2, threads);
    const float unsure = is_large ? 0.1f : 0.05f, sure = unsure + 0.2f;
    for (std::size_t i = 0; i < told.size(); ++i) {
        const float trust = std::max(part_of(confidence[i], unsure, sure),
                                     part_of(texture[i], no_texture, some_texture));
        if (views.is_lit(i) && std::isfinite(told[i]))
            disparity[i] += (1 - trust) * (told[i] - disparity[i]);
    }
}

} // namespace integral
