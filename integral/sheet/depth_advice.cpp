// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/sheet/depth_advice.h"

#include "integral/sheet/sheet_report.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

constexpr double enough = 0.95; // a sharp share that needs no greater change
constexpr double worth = 0.01;  // smallest gain in the sharp share that is reported
constexpr double printer_dpi[] = {300, 360, 600, 720, 1200, 1440, 2400, 2880};

/// Scene units per mm; 1 if nothing is known of the scene.
double units_per_mm(const FrameMetadata& metadata)
{
    return metadata.placement ? metadata.placement->units_per_mm : 1;
}

/// Distances from the scene's eye plane, scene units: the frame's eye_distances, or else the
/// distances of its pixels' surfaces.
std::vector<double> scene_distances(const DepthFrame& frame)
{
    if (!frame.eye_distances.empty())
        return {frame.eye_distances.begin(), frame.eye_distances.end()};
    const Collineation relief = relief_of(frame.metadata);
    std::vector<double> distances;
    for (std::size_t at = 0; at < frame.depth.size(); ++at)
        if (frame.imaged[at] > 0 && std::isfinite(frame.depth[at]))
            if (const auto z = preimage_depth(relief, frame.depth[at]))
                distances.push_back((scene_distance(frame.metadata) + *z) *
                                    units_per_mm(frame.metadata));
    return distances;
}

/// `beta`: the budget divided by the viewing distance.
DepthShares shares_of(const SceneFit& fit, const std::vector<double>& distances, double beta)
{
    DepthShares shares;
    shares.sharp = part_within(fit, distances, beta);
    const double within = part_within(fit, distances, soft_budgets * beta);
    shares.soft = within - shares.sharp;
    shares.beyond = 1 - within;
    return shares;
}

/// The change, unless its gain is too small to report.
std::optional<DepthRemedy> if_worth(double value, double sharp, double now)
{
    if (sharp < now + worth)
        return std::nullopt;
    return DepthRemedy{value, sharp};
}

/// The first of `values` (growing changes) whose sharp share reaches `enough` or, if less, the
/// share `now` plus 9/10 of the last value's gain. `sharp_at` returns a value's sharp share.
template <class SharpAt>
std::optional<DepthRemedy> least_change(const std::vector<double>& values, SharpAt sharp_at,
                                        double now)
{
    if (values.empty())
        return std::nullopt;
    const double most = sharp_at(values.back()),
                 requested = std::min(enough, now + 0.9 * (most - now));
    for (const double value : values)
        if (sharp_at(value) >= requested)
            return if_worth(value, sharp_at(value), now);
    return std::nullopt;
}

/// `sharp_with` returns the sharp share for the budget scaled by a factor.
template <class SharpWith>
std::optional<DepthRemedy> coarsest_film(const Film& film, double pixel, SharpWith sharp_with,
                                         double now)
{
    if (film.subpixels != Subpixels::none)
        return std::nullopt; // a panel's pixels cannot be changed
    const auto finer_by = [&](double dpi) { return pixel * dpi / mm_per_inch; };
    std::vector<double> finer;
    for (const double dpi : printer_dpi)
        if (finer_by(dpi) > 1.01)
            finer.push_back(dpi);
    return least_change(
        finer, [&](double dpi) { return sharp_with(finer_by(dpi)); }, now);
}

} // namespace

SceneFit fit_of(const FrameMetadata& metadata)
{
    return {scene_distance(metadata) * units_per_mm(metadata),
            metadata.parallax ? metadata.parallax->factor : 1};
}

DepthFrame as_scene_eye_sees(const DepthFrame& frame)
{
    if (frame.eye_distances.empty())
        return frame;
    const SceneFit fit = fit_of(frame.metadata);
    const double viewed = viewer_distance(frame.metadata);
    DepthFrame seen{{}, {}, frame.metadata, frame.eye_distances};
    for (const float distance : frame.eye_distances)
        seen.depth.push_back(std::isinf(distance) ? distance
                                                  : float(viewed * seen_depth(fit, distance)));
    seen.imaged.assign(seen.depth.size(), 1);
    return seen;
}

DepthAdvice depth_advice(const DepthFrame& frame, double budget)
{
    const FrameMetadata& metadata = frame.metadata;
    const std::vector<double> distances = scene_distances(frame);
    const SceneFit fit = fit_of(metadata);
    const double beta = budget / viewer_distance(metadata);
    DepthAdvice advice;
    advice.now = shares_of(fit, distances, beta);
    const auto ends = depth_ends(distances);
    if (ends && metadata.placement)
        for (const double budgets : {1.0, 2.0}) {
            const SceneFit to = fit_to_budget(*ends, {budgets * beta, {}, {}});
            advice.fits.push_back({budgets, to, shares_of(to, distances, beta)});
        }
    const auto sharp_with = [&](double finer) { return part_within(fit, distances, beta * finer); };
    advice.dpi = coarsest_film(metadata.film, counted(metadata).pixel, sharp_with,
                               advice.now.sharp);
    return advice;
}

} // namespace integral
