// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/reflections.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

constexpr int least_size = 128;              ///< of the views, pixels
constexpr double faint = 0.05;               ///< differences of colour that may be a reflection
constexpr float same = 0.1f;                 ///< disparities that differ less belong to one surface
constexpr float behind = 0.3f;               ///< a reflection is farther than the edges by more
constexpr int beside = 6;                    ///< pixels to each side, searched for a surface ...
constexpr float surface_share = 0.8f;        ///< ... which fills this share of that square
constexpr int around = 12;                   ///< pixels to each side ...
constexpr float least_share = 0.4f;          ///< ... and the share of them that must look mirrored
constexpr float sure = 0.4f, unsure = 0.03f; ///< most confidence of the map; least of the edges

/// The means of blocks of two by two pixels; a mean is lit if its four pixels are.
DepthView half_size(const DepthView& view, std::size_t width, std::size_t height)
{
    DepthView half;
    half.shift = view.shift;
    const auto means = [&](const std::vector<float>& values) {
        std::vector<float> to;
        to.reserve((width / 2) * (height / 2));
        for (std::size_t y = 0; y + 1 < height; y += 2)
            for (std::size_t x = 0; x + 1 < width; x += 2) {
                const float* v = values.data() + y * width + x;
                to.push_back(0.25f * (v[0] + v[1] + v[width] + v[width + 1]));
            }
        return to;
    };
    for (std::size_t c = 0; c < 3; ++c)
        half.channels[c] = means(view.channels[c]);
    if (!view.lit.empty())
        half.lit = means(view.lit);
    for (float& lit : half.lit)
        lit = lit == 1 ? 1.0f : 0.0f;
    return half;
}

ViewSet half_size(const ViewSet& views, int threads)
{
    ViewSet half;
    half.width = views.width / 2;
    half.height = views.height / 2;
    const auto of = [&](const DepthView& view) {
        return half_size(view, std::size_t(views.width), std::size_t(views.height));
    };
    half.middle = of(views.middle);
    half.colours = half.middle.channels;
    std::vector<const DepthView*> cross;
    for (const DepthView& view : views.others)
        if (is_in_cross(view.shift))
            cross.push_back(&view);
    half.others.resize(cross.size());
    for_each_row(int(cross.size()), threads,
                 [&](int k) { half.others[std::size_t(k)] = of(*cross[std::size_t(k)]); });
    return half;
}

/// Replaces each value by the mean of the values within `reach` pixels.
void take_means(std::vector<float>& values, int width, int height, int reach, int threads)
{
    const std::size_t columns = std::size_t(width);
    const float part = 1 / float(2 * reach + 1);
    std::vector<float> across(values.size());
    for_each_row(height, threads, [&](int y) {
        const float* row = values.data() + columns * std::size_t(y);
        float sum = 0;
        for (int i = -reach; i < reach; ++i)
            sum += row[std::clamp(i, 0, width - 1)];
        for (int x = 0; x < width; ++x) {
            sum += row[std::min(x + reach, width - 1)];
            across[columns * std::size_t(y) + std::size_t(x)] = part * sum;
            sum -= row[std::max(x - reach, 0)];
        }
    });
    for_each_row(height, threads, [&](int y) {
        float* to = values.data() + columns * std::size_t(y);
        std::fill(to, to + width, 0.0f);
        for (int j = y - reach; j <= y + reach; ++j) {
            const float* row = across.data() + columns * std::size_t(std::clamp(j, 0, height - 1));
            for (int x = 0; x < width; ++x)
                to[x] += part * row[x];
        }
    });
}

/// The depth of strong edges.
DepthMap depth_of_edges(const ViewSet& half, DisparityRange range, double step, int threads)
{
    VoteSettings tolerant;
    tolerant.noise = faint;
    const Votes votes(half, tolerant);
    DepthMap map = blank_map(half);
    Search(half, votes, {}, Labels({range.least / 2, range.greatest / 2}, step))
        .all_rows(threads, map, {});
    return map;
}

} // namespace

void flatten_reflections(const ViewSet& views, double step, int threads, DepthMap& map)
{
    const int width = views.width, height = views.height;
    if (std::min(width, height) < least_size)
        return;
    const ViewSet half = half_size(views, threads);
    if (half.others.empty())
        return;
    const DepthMap edges = depth_of_edges(half, map.range, step, threads);
    const auto in_half = [&](std::size_t i) {
        const std::size_t x = i % std::size_t(width), y = i / std::size_t(width);
        return std::min(y / 2, std::size_t(half.height - 1)) * std::size_t(half.width) +
               std::min(x / 2, std::size_t(half.width - 1));
    };
    const auto of_edges = [&](std::size_t i) { return 2 * edges.disparity[in_half(i)]; };
    std::vector<float> carried(views.pixels()), mirrored(views.pixels());
    for (std::size_t i = 0; i < carried.size(); ++i)
        carried[i] = std::fabs(map.disparity[i] - of_edges(i)) < same ? 1.0f : 0.0f;
    take_means(carried, width, height, beside, threads);
    for (std::size_t i = 0; i < mirrored.size(); ++i)
        mirrored[i] = carried[i] < surface_share && map.disparity[i] < of_edges(i) - behind &&
                              map.confidence[i] < sure && edges.confidence[in_half(i)] >= unsure
                          ? 1.0f
                          : 0.0f;
    std::vector<float> share = mirrored;
    take_means(share, width, height, around, threads);
    for (std::size_t i = 0; i < mirrored.size(); ++i)
        if (mirrored[i] > 0 && share[i] > least_share) {
            map.disparity[i] = of_edges(i);
            map.confidence[i] = edges.confidence[in_half(i)];
        }
}

} // namespace integral
