// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/edge_response.h"

#include "integral/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

Plane plane_of(int width, int height)
{
    return {width, height, std::vector<float>(std::size_t(width) * height), 0};
}

/// Three planes: the scan's colours in its encoding (linear light as sRGB), reduced.
std::vector<Plane> reduced_colours(const Image& scan, int reduction, int threads)
{
    std::vector<Plane> planes(3, plane_of(scan.width / reduction, scan.height / reduction));
    const bool linear = scan.encoding.kind == Encoding::Kind::linear;
    const float part = 1.0f / (reduction * reduction);
    for_each_row(planes[0].height, threads, [&](int y) {
        for (int x = 0; x < planes[0].width; ++x) {
            float sum[3] = {0, 0, 0};
            for (int j = 0; j < reduction; ++j)
                for (int i = 0; i < reduction; ++i) {
                    const Colour c = stored_pixel(scan, x * reduction + i, y * reduction + j);
                    const float values[3] = {c.r, c.g, c.b};
                    for (int k = 0; k < 3; ++k)
                        sum[k] += linear ? float(encode({}, values[k])) : values[k];
                }
            for (int k = 0; k < 3; ++k)
                planes[k].at(x, y) = sum[k] * part;
        }
    });
    return planes;
}

/// Mean over `reach` neighbours each way along each axis, fewer at the plane's sides.
Plane box_mean(const Plane& plane, int reach, int threads)
{
    const auto sweep = [&](const Plane& from, Plane& to, int lines, int length,
                           std::size_t line_step, std::size_t step) {
        for_each_row(lines, threads, [&](int line) {
            const float* in = from.values.data() + line * line_step;
            float* out = to.values.data() + line * line_step;
            double sum = 0;
            for (int k = 0; k < std::min(reach, length); ++k)
                sum += in[k * step];
            for (int k = 0; k < length; ++k) {
                if (k + reach < length)
                    sum += in[(k + reach) * step];
                if (k - reach - 1 >= 0)
                    sum -= in[(k - reach - 1) * step];
                out[k * step] = float(
                    sum / (std::min(length - 1, k + reach) - std::max(0, k - reach) + 1));
            }
        });
    };
    Plane across = plane_of(plane.width, plane.height), both = across;
    sweep(plane, across, plane.height, plane.width, plane.width, 1);
    sweep(across, both, plane.width, plane.height, 1, plane.width);
    return both;
}

} // namespace

Plane edge_response(const Image& scan, int reduction, double reach, int threads,
                    std::optional<Vec2> across_lenses)
{
    const std::vector<Plane> colours = reduced_colours(scan, reduction, threads);
    const int width = colours[0].width, height = colours[0].height;
    Plane edges = plane_of(width, height);
    for_each_row(height, threads, [&](int y) {
        const int above = std::max(0, y - 1), below = std::min(height - 1, y + 1);
        for (int x = 0; x < width; ++x) {
            const int left = std::max(0, x - 1), right = std::min(width - 1, x + 1);
            double square = 0;
            for (const Plane& c : colours) {
                const double across = (c.at(right, above) - c.at(left, above)) +
                                      2 * (c.at(right, y) - c.at(left, y)) +
                                      (c.at(right, below) - c.at(left, below));
                const double down = (c.at(left, below) - c.at(left, above)) +
                                    2 * (c.at(x, below) - c.at(x, above)) +
                                    (c.at(right, below) - c.at(right, above));
                if (across_lenses) {
                    const double along_it = across * across_lenses->x + down * across_lenses->y;
                    square += along_it * along_it;
                } else {
                    square += across * across + down * down;
                }
            }
            edges.at(x, y) = float(std::sqrt(square));
        }
    });
    double whole = 0;
    for (const float g : edges.values)
        whole += g;
    whole /= std::max<std::size_t>(1, edges.values.size());
    const Plane around = box_mean(edges, std::max(1, int(std::lround(reach))), threads);
    for (std::size_t k = 0; k < edges.values.size(); ++k) {
        const double level = around.values[k] + 0.1 * whole;
        edges.values[k] = level > 0 ? float(edges.values[k] / (edges.values[k] + level)) : 0;
    }
    return edges;
}

Plane blurred(const Plane& plane, double deviation, int threads)
{
    const int reach = std::max(1, int(std::ceil(3.5 * deviation)));
    std::vector<float> weights;
    double sum = 0;
    for (int k = -reach; k <= reach; ++k) {
        weights.push_back(float(std::exp(-0.5 * k * k / (deviation * deviation))));
        sum += weights.back();
    }
    for (float& weight : weights)
        weight = float(weight / sum);
    Plane across = plane_of(plane.width, plane.height), both = across;
    for_each_row(plane.height, threads, [&](int y) {
        for (int x = 0; x < plane.width; ++x) {
            float value = 0;
            for (int k = -reach; k <= reach; ++k)
                value += weights[k + reach] * plane.at(std::clamp(x + k, 0, plane.width - 1), y);
            across.at(x, y) = value;
        }
    });
    for_each_row(plane.height, threads, [&](int y) {
        for (int k = -reach; k <= reach; ++k) {
            const float* in = across.values.data() +
                              std::size_t(std::clamp(y + k, 0, plane.height - 1)) * plane.width;
            float* out = both.values.data() + std::size_t(y) * plane.width;
            for (int x = 0; x < plane.width; ++x)
                out[x] += weights[k + reach] * in[x];
        }
    });
    double sum_of_all = 0;
    for (const float value : both.values)
        sum_of_all += value;
    both.mean = sum_of_all / std::max<std::size_t>(1, both.values.size());
    return both;
}

Plane difference(Plane a, const Plane& b)
{
    for (std::size_t k = 0; k < a.values.size(); ++k)
        a.values[k] -= b.values[k];
    a.mean -= b.mean;
    return a;
}

} // namespace integral
