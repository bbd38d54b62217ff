// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/plane_filter.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

constexpr int passes = 3;
constexpr int columns_at_once = 64;
constexpr float too_little = 1e-20f; ///< weight

std::vector<float> distances(const ViewSet& views, const Reach& reach, std::size_t step)
{
    std::vector<float> far(views.pixels(), 1);
    const float slow = float(reach.slow_change), scale = float(reach.pixels / reach.even_colour);
    for (std::size_t i = 0; i + step < far.size(); ++i) {
        float difference = 0;
        for (const auto& channel : views.colours)
            difference += std::fabs(channel[i + step] - channel[i]);
        far[i] += scale * std::max(0.0f, difference - slow);
    }
    return far;
}

/// The share of a value that is carried over a distance. Exactly 0 across edges: where the weights
/// beyond an edge are tiny, any remainder would dominate them.
float part_carried(float power) { return power < -18 ? 0 : std::exp(power); }

/// to += part (from - to)
void carry(float* to, const float* from, const float* part, int count)
{
    for (int i = 0; i < count; ++i)
        to[i] += part[i] * (from[i] - to[i]);
}

/// Weighted moments of positions (relative to the view's middle) and of values.
enum Moment { w, d, x, y, xx, xy, yy, xd, yd, moments };

/// The value at (px, py) of the plane that the moments around that pixel determine.
float plane_at(const double m[moments], double px, double py)
{
    constexpr double narrow = 9, far = 0.15; // square pixels; share of the squared distance
    const double mean = m[d] / m[w], mx = m[x] / m[w], my = m[y] / m[w], dx = px - mx, dy = py - my,
                 ridge = narrow + far * (dx * dx + dy * dy),
                 sxx = std::max(0.0, m[xx] / m[w] - mx * mx) + ridge,
                 syy = std::max(0.0, m[yy] / m[w] - my * my) + ridge, sxy = m[xy] / m[w] - mx * my,
                 sxd = m[xd] / m[w] - mx * mean, syd = m[yd] / m[w] - my * mean,
                 area = sxx * syy - sxy * sxy;
    if (!(area > 1e-3 * sxx * syy))
        return float(mean);
    return float(mean + ((sxd * syy - syd * sxy) * dx + (syd * sxx - sxd * sxy) * dy) / area);
}

} // namespace

PlaneFilter::PlaneFilter(const ViewSet& views, const Reach& reach, int threads)
    : width_(views.width),
      height_(views.height),
      threads_(threads),
      reach_(reach.pixels),
      across_(distances(views, reach, 1)),
      down_(distances(views, reach, std::size_t(views.width)))
{
}

/// Carries values along row y, forwards and backwards, and then stores in row y of `carried` the
/// shares that are carried to the next row.
void PlaneFilter::smooth_row(std::vector<Plane>& planes, int y, float slope, Plane& carried) const
{
    const std::size_t width = std::size_t(width_), first = width * std::size_t(y);
    float* part = carried.data() + first;
    for (std::size_t i = 0; i < width; ++i)
        part[i] = part_carried(slope * across_[first + i]);
    for (Plane& plane : planes) {
        float* row = plane.data() + first;
        for (std::size_t i = 1; i < width; ++i)
            row[i] += part[i - 1] * (row[i - 1] - row[i]);
        for (std::size_t i = width - 1; i > 0; --i)
            row[i - 1] += part[i - 1] * (row[i] - row[i - 1]);
    }
    for (std::size_t i = 0; i < width; ++i)
        part[i] = part_carried(slope * down_[first + i]);
}

void PlaneFilter::smooth_columns(std::vector<Plane>& planes, int first, int count,
                                 const Plane& carried) const
{
    const std::size_t width = std::size_t(width_);
    const auto at = [&](int y) { return width * std::size_t(y) + std::size_t(first); };
    for (Plane& plane : planes) {
        float* values = plane.data();
        for (int y = 1; y < height_; ++y)
            carry(values + at(y), values + at(y - 1), carried.data() + at(y - 1), count);
        for (int y = height_ - 1; y > 0; --y)
            carry(values + at(y - 1), values + at(y), carried.data() + at(y - 1), count);
    }
}

void PlaneFilter::smooth(std::vector<Plane>& planes) const
{
    Plane carried(across_.size());
    for (int pass = 0; pass < passes; ++pass) {
        const double spread = reach_ * std::sqrt(3.0) * std::pow(2.0, passes - pass - 1) /
                              std::sqrt(std::pow(4.0, passes) - 1);
        const float slope = float(-std::sqrt(2.0) / spread);
        for_each_row(height_, threads_, [&](int row) { smooth_row(planes, row, slope, carried); });
        for_each_row((width_ + columns_at_once - 1) / columns_at_once, threads_, [&](int k) {
            const int first = k * columns_at_once;
            smooth_columns(planes, first, std::min(columns_at_once, width_ - first), carried);
        });
    }
}

PlaneFilter::Fit PlaneFilter::means(const std::vector<float>& value,
                                    const std::vector<float>& weight) const
{
    std::vector<Plane> m{weight, Plane(weight.size())};
    for (std::size_t i = 0; i < weight.size(); ++i)
        m[1][i] = weight[i] > 0 ? weight[i] * value[i] : 0;
    smooth(m);
    for (std::size_t i = 0; i < weight.size(); ++i)
        m[1][i] = m[0][i] > too_little ? m[1][i] / m[0][i] : NAN;
    return {std::move(m[1]), std::move(m[0])};
}

PlaneFilter::Fit PlaneFilter::planes(const std::vector<float>& value,
                                     const std::vector<float>& weight) const
{
    const std::size_t width = std::size_t(width_);
    const float middle_x = 0.5f * float(width_), middle_y = 0.5f * float(height_);
    std::vector<Plane> m(moments, Plane(weight.size()));
    for_each_row(height_, threads_, [&](int row) {
        const float py = float(row) - middle_y;
        for (int column = 0; column < width_; ++column) {
            const std::size_t i = width * std::size_t(row) + std::size_t(column);
            const float px = float(column) - middle_x, part = weight[i],
                        product = part > 0 ? part * value[i] : 0;
            const float of[moments] = {part,           product,        part * px,
                                       part * py,      part * px * px, part * px * py,
                                       part * py * py, product * px,   product * py};
            for (int k = 0; k < moments; ++k)
                m[std::size_t(k)][i] = of[k];
        }
    });
    smooth(m);
    Fit fit{Plane(weight.size()), m[w]};
    for_each_row(height_, threads_, [&](int row) {
        for (int column = 0; column < width_; ++column) {
            const std::size_t i = width * std::size_t(row) + std::size_t(column);
            double of[moments];
            for (int k = 0; k < moments; ++k)
                of[k] = m[std::size_t(k)][i];
            fit.value[i] = of[w] > too_little
                               ? plane_at(of, float(column) - middle_x, float(row) - middle_y)
                               : NAN;
        }
    });
    return fit;
}

} // namespace integral
