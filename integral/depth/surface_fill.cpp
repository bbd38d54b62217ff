// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/surface_fill.h"

#include "integral/depth/plane_filter.h"
#include "integral/depth/texture.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

constexpr double finest = 3;             ///< reach of the finest planes, pixels
constexpr double even_colour = 0.04;     ///< as Reach::even_colour
constexpr double slow_change = 0.01;     ///< as Reach::slow_change: shading is no edge
constexpr float half_confidence = 0.3f;  ///< confidence at which a measurement has weight 1/2
constexpr float near = 0.2f, far = 0.3f; ///< difference from the coarser planes at which a weight
                                         ///< is halved: of an outline that is nearer; otherwise
constexpr float any = 1e6f;              ///< no weight is halved
constexpr float least_part = 0.01f;      ///< remaining part of the weight of any measurement
constexpr int edge_margin = 4;           ///< pixels
constexpr double clear_edge = 0.02;      ///< texture (rms) around a pixel near an edge
constexpr float few = 8;                 ///< weight within a square of a plane's reach at which it
                                         ///< counts as much as the coarser planes
constexpr float plane_weight = 0.2f;     ///< of the planes; a measurement's is its weight squared

/// Weight of each measurement, 0 to 1.
std::vector<float> weights(const ViewSet& views, const std::vector<float>& confidence)
{
    std::vector<float> weight(confidence.size());
    for (std::size_t i = 0; i < weight.size(); ++i) {
        const float square = confidence[i] * confidence[i];
        weight[i] = views.is_lit(i) ? square / (square + half_confidence * half_confidence) : 0;
    }
    return weight;
}

/// Whether each pixel is near a colour edge, which may be an outline. Fainter texture belongs to
/// the pixel's own surface.
std::vector<char> edges(const ViewSet& views, int threads)
{
    const Texture texture(views);
    std::vector<char> is_at_edge(views.pixels());
    for_each_row(views.height, threads, [&](int y) {
        char* row = is_at_edge.data() + std::size_t(y) * std::size_t(views.width);
        for (int x = 0; x < views.width; ++x)
            row[x] = texture.at(x, y, edge_margin) > clear_edge;
    });
    return is_at_edge;
}

/// Disparities, their weights, and whether they are near a colour edge.
struct Measurements {
    const std::vector<float>& disparity;
    std::vector<float> weight;
    std::vector<char> is_at_edge;
};

/// The weights, reduced where a disparity differs from the coarser planes: halved where it differs
/// by `farther`, or, near a colour edge, is nearer by `near`.
std::vector<float> robust(const Measurements& of, const std::vector<float>& coarse, float farther)
{
    std::vector<float> to(of.weight.size());
    for (std::size_t i = 0; i < to.size(); ++i) {
        const float off = of.disparity[i] - coarse[i];
        if (!std::isfinite(off))
            continue;
        const float part = off / (off > 0 && of.is_at_edge[i] ? near : farther),
                    square = part * part;
        to[i] = of.weight[i] * std::max(least_part, 1 / (1 + square * square));
    }
    return to;
}

/// Moves `coarse` towards planes fitted over `reach` pixels, where these have weight.
void refine(const PlaneFilter& filter, double reach, const Measurements& of,
            std::vector<float>& coarse)
{
    const PlaneFilter::Fit fit = filter.planes(of.disparity, robust(of, coarse, far));
    const float little = few / float(reach * reach);
    for (std::size_t i = 0; i < coarse.size(); ++i) {
        if (!std::isfinite(fit.value[i]))
            continue;
        const float share = fit.weight[i] / (fit.weight[i] + little);
        coarse[i] = std::isfinite(coarse[i]) ? coarse[i] + share * (fit.value[i] - coarse[i])
                                             : fit.value[i];
    }
}

} // namespace

void fill_surfaces(const ViewSet& views, double reach, int threads, std::vector<float>& disparity,
                   const std::vector<float>& confidence)
{
    constexpr int first_rounds = 6; // until the means are behind edges that are too near
    const Measurements of{disparity, weights(views, confidence), edges(views, threads)};
    std::vector<float> surface;
    for (double pixels = reach; pixels >= finest; pixels /= 2) {
        const PlaneFilter filter(views, {pixels, even_colour, slow_change}, threads);
        if (surface.empty()) {
            surface = filter.means(disparity, of.weight).value;
            for (int round = 0; round < first_rounds; ++round)
                surface = filter.means(disparity, robust(of, surface, any)).value;
        }
        refine(filter, pixels, of, surface);
    }
    for (std::size_t i = 0; i < surface.size(); ++i)
        if (views.is_lit(i) && std::isfinite(surface[i]))
            disparity[i] += plane_weight / (of.weight[i] * of.weight[i] + plane_weight) *
                            (surface[i] - disparity[i]);
}

} // namespace integral
