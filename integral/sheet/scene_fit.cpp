// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/sheet/scene_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace integral {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double most_beta = 0.9;

/// The greatest parallax up to 1 that shows both ends within FitRequest::beta of the sheet.
double parallax_for(const DepthEnds& ends, double sheet, double beta)
{
    double parallax = 1;
    if (sheet > ends.near)
        parallax = std::min(parallax, beta * ends.near / ((1 - beta) * (sheet - ends.near)));
    if (ends.far == infinity)
        return std::min(parallax, beta / (1 + beta));
    if (ends.far > sheet)
        parallax = std::min(parallax, beta * ends.far / ((1 + beta) * (ends.far - sheet)));
    return parallax;
}

/// The sheet's distance at which both ends are seen equally far from the sheet, one before and one
/// behind it: the positive root of 2 K D^2 + (1 - 2 K)(near + far) D - 2 (1 - K) near far = 0, K
/// the parallax. Empty if far is infinite and K >= 1/2.
std::optional<double> balanced_sheet(const DepthEnds& ends, double parallax)
{
    const double k = parallax;
    if (ends.far == infinity)
        return k < 0.5 ? std::optional(2 * (1 - k) * ends.near / (1 - 2 * k)) : std::nullopt;
    const double a = 2 * k, b = (1 - 2 * k) * (ends.near + ends.far),
                 c = -2 * (1 - k) * ends.near * ends.far;
    // The sign of b decides which form has no cancellation. For K <= 1, c <= 0. For K > 1 both
    // roots are positive, and the smaller one puts both ends on this side of the viewer's infinity.
    const double root = std::sqrt(std::max(0.0, b * b - 4 * a * c));
    return b > 0 ? -2 * c / (b + root) : (root - b) / (2 * a);
}

} // namespace

std::optional<DepthEnds> depth_ends(std::vector<double> distances)
{
    if (distances.empty())
        return std::nullopt;
    const auto part = [&](double fraction) {
        const auto at = distances.begin() +
                        std::ptrdiff_t(std::lround(fraction * double(distances.size() - 1)));
        std::nth_element(distances.begin(), at, distances.end());
        return *at;
    };
    DepthEnds ends{part(0.05), part(0.95)};
    if (ends.near == infinity) // under one pixel in twenty shows a surface: take the nearest
        ends.near = *std::min_element(distances.begin(), distances.end());
    if (ends.near == infinity)
        return std::nullopt;
    return ends;
}

SceneFit fit_to_budget(const DepthEnds& ends, const FitRequest& request)
{
    const double beta = std::min(request.beta, most_beta);
    if (request.sheet_distance)
        return {*request.sheet_distance,
                request.parallax.value_or(parallax_for(ends, *request.sheet_distance, beta))};
    if (request.parallax) {
        const double k = *request.parallax;
        if (const auto sheet = balanced_sheet(ends, k))
            return {*sheet, k};
        return {ends.near * (1 + beta / ((1 - beta) * k)), k};
    }
    // c = 1/K - 1, K the parallax
    const double ratio = ends.far / ends.near;
    const double c = ratio == infinity ? 1 / beta
                                       : (ratio * (1 - beta) - (1 + beta)) /
                                             (beta * ((1 + beta) + ratio * (1 - beta)));
    if (!(c > 0))
        return {*balanced_sheet(ends, 1), 1};
    const double k = 1 / (1 + c);
    return {ends.near * (k + beta * (1 - k)) / (k * (1 - beta)), k};
}

double seen_depth(const SceneFit& fit, double distance)
{
    const double k = fit.parallax;
    if (distance == infinity)
        return k < 1 ? k / (1 - k) : infinity;
    const double below = k * fit.sheet_distance + (1 - k) * distance;
    return below > 0 ? k * (distance - fit.sheet_distance) / below : infinity;
}

double part_within(const SceneFit& fit, const std::vector<double>& distances, double beta)
{
    // Tolerances: a fit puts a whole sky exactly on the border; a draft's film, whose size is
    // rounded to its pixels, gives a slightly different budget from the print's.
    constexpr double of_floats = 1 + 1e-4, of_sky = 1 + 5e-3;
    const auto is_within = [&](double distance) {
        return std::fabs(seen_depth(fit, distance)) <=
               beta * (distance == infinity ? of_sky : of_floats);
    };
    return distances.empty() ? 0
                             : double(std::count_if(distances.begin(), distances.end(),
                                                    is_within)) /
                                   double(distances.size());
}

} // namespace integral
