// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/depth_advice.h"

#include "integral/lightfield/sheet_report.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

constexpr double enough = 0.95; // sharp: more is not sought
constexpr double worth = 0.01;  // gain in sharp below which a change is not worth a word
constexpr int flattest = 25;    // percent: depths are not compressed further: the scene would be a
                                // relief
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

double rounded(double value, int digits)
{
    const double unit = std::pow(10, std::floor(std::log10(std::fabs(value))) - digits + 1);
    return std::round(value / unit) * unit;
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

/// The distances from the scene's eye at which the sheet may stand, in scene units, and what is
/// sharp there. A sheet at D has k = D/viewed units per mm if the window sets the scale (`viewed`:
/// mm from the scene's eye to the sheet, for every D), else a fixed k.
struct SheetPlaces {
    double distance, units_per_mm, viewed, budget;
    bool fixed_scale;

    /// From where to where things are sharp about a sheet at D, scene units from the eye.
    double low(double d) const
    {
        return fixed_scale ? d - budget * units_per_mm : d * (1 - budget / viewed);
    }
    double high(double d) const
    {
        return fixed_scale ? d + budget * units_per_mm : d * (1 + budget / viewed);
    }
    /// The sheet's distance for which things are sharp from `place` on, and up to `place`.
    double with_low(double place) const
    {
        return fixed_scale ? place + budget * units_per_mm : place / (1 - budget / viewed);
    }
    double with_high(double place) const
    {
        return fixed_scale ? place - budget * units_per_mm : place / (1 + budget / viewed);
    }
};

/// The sheet's distance with most of the sorted depths sharp. Among several that hold the same, the
/// middle one.
std::optional<DepthRemedy> best_sheet(const std::vector<double>& depths, const SheetPlaces& places,
                                      double now)
{
    if (!places.fixed_scale && places.budget >= places.viewed)
        return std::nullopt; // everything in front is sharp already
    std::vector<double> from_eye;
    for (const double depth : depths)
        from_eye.push_back(places.distance + depth * places.units_per_mm);
    std::size_t most = 0, end = 0;
    double best = places.distance;
    for (std::size_t first = 0; first < from_eye.size(); ++first) {
        const double farthest = places.with_low(from_eye[first]);
        while (end < from_eye.size() && from_eye[end] <= places.high(farthest))
            ++end;
        if (end - first <= most)
            continue;
        most = end - first;
        best = 0.5 * (farthest + places.with_high(from_eye[end - 1]));
    }
    if (!(best > 0))
        return std::nullopt;
    best = rounded(best, 4);
    return if_worth(best, share(from_eye, places.low(best), places.high(best)), now);
}

std::optional<DepthRemedy> least_compression(const std::vector<double>& depths, double budget,
                                             double now)
{
    const auto sharp_at = [&](double factor) {
        return share(depths, -budget / factor, budget / factor);
    };
    std::vector<double> factors;
    for (int percent = 95; percent >= flattest; percent -= 5)
        factors.push_back(percent / 100.0);
    return least_change(factors, sharp_at, now);
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
    const double now = advice.now.sharp;
    if (metadata.placement) {
        const Placement& at = *metadata.placement;
        const double distance = at.sheet_distance > 0
                                    ? at.sheet_distance
                                    : metadata.aperture.distance * at.units_per_mm;
        advice.sheet_distance = distance;
        advice.sheet = best_sheet(
            depths,
            {distance, at.units_per_mm, distance / at.units_per_mm, budget, at.scale_is_given},
            now);
    }
    advice.compress = least_compression(depths, budget, now);
    advice.dpi = coarsest_film(depths, metadata.film, counted(metadata).pixel, budget, now);
    return advice;
}

} // namespace integral
