// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/edge_filter.h"

#include "integral/depth/row_loops.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

float squared_difference(const ColourPlanes& colours, std::size_t a, std::size_t b)
{
    float sum = 0;
    for (const auto& channel : colours) {
        const float d = channel[a] - channel[b];
        sum += d * d;
    }
    return sum;
}

/// Weight of a neighbour at a fraction of the filter's half-width.
double spatial_weight(double part) { return std::exp(-1.5 * part * part); }

/// For each pixel: 1 / (1 + the weights of its neighbours on both sides); its own weight is 1.
std::vector<float> inverse_sums(const std::vector<std::vector<float>>& weights, std::size_t count,
                                std::size_t step)
{
    std::vector<float> sum(count, 1.0f);
    for (std::size_t k = 1; k <= weights.size(); ++k)
        for (std::size_t i = 0; i + k * step < count; ++i) {
            sum[i] += weights[k - 1][i];
            sum[i + k * step] += weights[k - 1][i];
        }
    for (float& s : sum)
        s = 1 / s;
    return sum;
}

/// Weighted mean of each value and its neighbours, `step` values apart, on both sides.
void filter(const float* from, float* to, const std::vector<std::vector<float>>& weights,
            const std::vector<float>& norm, std::size_t step)
{
    const std::size_t count = norm.size();
    std::copy(from, from + count, to);
    for (std::size_t k = 1; k <= weights.size(); ++k) {
        const std::size_t off = k * step;
        if (off >= count)
            break;
        const float* weight = weights[k - 1].data();
        add_product(to, weight, from + off, int(count - off));
        add_product(to + off, weight, from, int(count - off));
    }
    multiply(to, norm.data(), int(count));
}

} // namespace

EdgeFilter::EdgeFilter(const ViewSet& views, int first, int rows,
                       const EdgeFilterSettings& settings)
    : width_(views.width), rows_(rows), settings_(settings)
{
    across_.resize(std::size_t(settings.across));
    for (int k = 1; k <= settings.across; ++k)
        weigh(views, first, k, 0, spatial_weight(double(k) / settings.across),
              across_[std::size_t(k - 1)]);
    down_.resize(std::size_t(settings.down));
    for (int k = 1; k <= settings.down; ++k)
        weigh(views, first, 0, k, spatial_weight(double(k) / settings.down),
              down_[std::size_t(k - 1)]);
    const std::size_t count = std::size_t(width_) * rows_;
    across_norm_ = inverse_sums(across_, count, 1);
    down_norm_ = inverse_sums(down_, count, std::size_t(width_));
}

void EdgeFilter::weigh(const ViewSet& views, int first, int step_x, int step_y, double spatial,
                       std::vector<float>& weights) const
{
    weights.assign(std::size_t(width_) * rows_, 0);
    const float sharpness = float(1 / (settings_.colour * settings_.colour));
    for (int y = 0; y + step_y < rows_; ++y)
        for (int x = 0; x + step_x < width_; ++x) {
            const std::size_t a = std::size_t(first + y) * width_ + x,
                              b = a + std::size_t(step_y) * width_ + step_x;
            if (views.is_lit(a) && views.is_lit(b))
                weights[std::size_t(y) * width_ + x] = float(spatial) *
                                                       std::exp(
                                                           -sharpness *
                                                           squared_difference(views.colours, a, b));
        }
}

void EdgeFilter::apply(float* plane, float* other) const
{
    filter(plane, other, down_, down_norm_, std::size_t(width_));
    filter(other, plane, across_, across_norm_, 1);
}

void weighted_median(const ViewSet& views, const std::vector<float>& values,
                     const std::vector<float>& weight, const EdgeFilterSettings& settings,
                     int first, int last, std::vector<float>& to)
{
    const float sharpness = float(1 / (settings.colour * settings.colour));
    const int width = views.width, height = views.height;
    std::vector<std::pair<float, float>> near; // value, weight
    for (int y = first; y < last; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t at = std::size_t(y) * width + x;
            near.clear();
            float sum = 0;
            for (int j = std::max(0, y - settings.down);
                 j <= std::min(height - 1, y + settings.down); ++j)
                for (int i = std::max(0, x - settings.across);
                     i <= std::min(width - 1, x + settings.across); ++i) {
                    const std::size_t other = std::size_t(j) * width + i;
                    const float w = weight[other];
                    if (!(w > 0))
                        continue;
                    const float d = sharpness * squared_difference(views.colours, at, other);
                    if (d > 9)
                        continue;
                    near.emplace_back(values[other], w / (1 + d * d));
                    sum += near.back().second;
                }
            to[at] = values[at];
            if (near.empty() || !views.is_lit(at))
                continue;
            std::sort(near.begin(), near.end());
            float below = 0;
            for (const auto& [value, w] : near)
                if ((below += w) >= 0.5f * sum) {
                    to[at] = value;
                    break;
                }
        }
}

} // namespace integral
