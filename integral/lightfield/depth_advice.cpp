// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/depth_advice.h"

#include "integral/lightfield/sheet_report.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

constexpr double enough = 0.95; // sharp: more is not sought
constexpr double worth = 0.01;  // gain in sharp below which a change is not worth a word
constexpr double printer_dpi[] = {300, 360, 600, 720, 1200, 1440, 2400, 2880};

/// Depths of a frame's surfaces, mm, in ascending order.
std::vector<double> sorted_depths(const DepthFrame& frame)
{
    std::vector<double> depths;
    for (std::size_t k = 0; k < frame.depth.size(); ++k)
        if (frame.imaged[k] > 0 && std::isfinite(frame.depth[k]))
            depths.push_back(frame.depth[k]);
    std::sort(depths.begin(), depths.end());
    return depths;
}

/// The part of sorted depths within [low, high].
double share(const std::vector<double>& depths, double low, double high)
{
    const auto first = std::lower_bound(depths.begin(), depths.end(), low);
    const auto last = std::upper_bound(first, depths.end(), high);
    return double(last - first) / double(depths.size());
}

/// The change, if it is worth a word.
std::optional<DepthRemedy> if_worth(double value, double sharp, double now)
{
    if (sharp < now + worth)
        return std::nullopt;
    return DepthRemedy{value, sharp};
}

/// Of changes from small to great, the smallest that makes enough sharp, or else nearly as much as
/// the greatest change. `sharp_at` says what a value makes sharp.
template <class SharpAt>
std::optional<DepthRemedy> least_change(const std::vector<double>& values, SharpAt sharp_at,
                                        double now)
{
    if (values.empty())
        return std::nullopt;
    const double most = sharp_at(values.back()),
                 wanted = std::min(enough, now + 0.9 * (most - now));
    for (const double value : values)
        if (sharp_at(value) >= wanted)
            return if_worth(value, sharp_at(value), now);
    return std::nullopt;
}

std::optional<DepthRemedy> coarsest_film(const std::vector<double>& depths, const Film& film,
                                         double pixel, double budget, double now)
{
    if (film.subpixels != Subpixels::none)
        return std::nullopt; // a panel, which has the pixels that it has
    const auto sharp_at = [&](double dpi) {
        const double finer = pixel * dpi / mm_per_inch;
        return share(depths, -budget * finer, budget * finer);
    };
    std::vector<double> finer;
    for (const double dpi : printer_dpi)
        if (pixel * dpi / mm_per_inch > 1.01)
            finer.push_back(dpi);
    return least_change(finer, sharp_at, now);
}

/// The scene's own distances from its eye plane of sorted depths, in scene units.
std::vector<double> distances_of(const std::vector<double>& depths, const FrameMetadata& metadata)
{
    const Collineation relief = relief_of(metadata);
    const double k = metadata.placement->units_per_mm;
    std::vector<double> distances;
    for (const double depth : depths)
        if (const auto z = preimage_depth(relief, depth))
            distances.push_back((scene_distance(metadata) + *z) * k);
    return distances;
}

FitAdvice fit_advice(const std::vector<double>& distances, const DepthEnds& ends, double budgets,
                     double beta)
{
    FitAdvice advice;
    advice.budgets = budgets;
    advice.fit = fit_to_budget(ends, {budgets * beta, {}, {}});
    advice.shares.sharp = part_within(advice.fit, distances, beta);
    advice.shares.soft = part_within(advice.fit, distances, soft_budgets * beta) -
                         advice.shares.sharp;
    advice.shares.beyond = 1 - advice.shares.sharp - advice.shares.soft;
    return advice;
}

} // namespace

DepthAdvice depth_advice(const DepthFrame& frame, double budget)
{
    const std::vector<double> depths = sorted_depths(frame);
    const FrameMetadata& metadata = frame.metadata;
    DepthAdvice advice;
    const double soft = share(depths, -soft_budgets * budget, soft_budgets * budget);
    advice.now.sharp = share(depths, -budget, budget);
    advice.now.soft = soft - advice.now.sharp;
    advice.now.beyond = 1 - soft;
    if (metadata.placement) {
        const std::vector<double> distances = distances_of(depths, metadata);
        if (const auto ends = depth_ends(distances))
            for (const double budgets : {1.0, 2.0})
                advice.fits.push_back(fit_advice(distances, *ends, budgets,
                                                 budget / viewer_distance(metadata)));
    }
    advice.dpi = coarsest_film(depths, metadata.film, counted(metadata).pixel, budget,
                               advice.now.sharp);
    return advice;
}

} // namespace integral
