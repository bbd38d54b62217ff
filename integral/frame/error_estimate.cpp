// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/frame/error_estimate.h"

#include "integral/base/constants.h"

#include <algorithm>
#include <cmath>

namespace integral {

double OutputCurve::operator()(double value) const
{
    const double cut = value > 0 ? std::min(value, 1.0) : 0; // NaN: 0
    return same_encoding(working, file) ? cut : encode(file, decode(working, cut));
}

namespace {

double squared_difference(const OutputCurve& curve, const Light& a, const Light& b)
{
    double sum = 0;
    for (std::size_t channel = 0; channel < a.size(); ++channel) {
        const double difference = curve(a[channel]) - curve(b[channel]);
        sum += difference * difference;
    }
    return sum / a.size();
}

} // namespace

double audited_error(const OutputCurve& curve, const Light& pixel, const Light& a, const Light& b)
{
    double sum = 0;
    for (std::size_t channel = 0; channel < pixel.size(); ++channel) {
        const double first = curve(a[channel]), second = curve(b[channel]),
                     together = curve(0.5 * (a[channel] + b[channel])),
                     truth = 2 * together - 0.5 * (first + second),
                     error = curve(pixel[channel]) - truth;
        sum += error * error - 0.25 * (first - second) * (first - second);
    }
    return sum / pixel.size();
}

double halves_error(const OutputCurve& curve, const Light& a, const Light& b, int first, int second)
{
    const double part = first / (double(first) + second);
    Light mean;
    for (std::size_t channel = 0; channel < mean.size(); ++channel)
        mean[channel] = part * a[channel] + (1 - part) * b[channel];
    return part * squared_difference(curve, a, mean) +
           (1 - part) * squared_difference(curve, b, mean);
}

void ErrorSums::add(double squared_error)
{
    ++pixels;
    sum += squared_error;
    sum_of_squares += squared_error * squared_error;
    largest = std::max(largest, squared_error);
}

void ErrorSums::add(const ErrorSums& other)
{
    pixels += other.pixels;
    sum += other.sum;
    sum_of_squares += other.sum_of_squares;
    largest = std::max(largest, other.largest);
}

namespace {

constexpr double two_sided_95 = 1.959963984540054; // of a normal distribution

/// A mean, its standard error, and the half-width of its interval.
struct Mean {
    double value, deviation, reach;
};

/// Lower bound of an RMS error, as a fraction of that error. `reach`: half-width of the mean
/// square's interval, as a fraction of the mean square; must be below 1. The bound is the one for
/// equal errors in a Poisson-distributed number of pixels: a gamma distribution's quantile (Fay and
/// Feuer 1997), by the formula of Wilson and Hilferty (1931) to 0.7%.
double lower_bound_of_root(double reach)
{
    const double deviation = reach / two_sided_95;
    return std::pow(1 - deviation * deviation / 9 - reach / 3, 1.5);
}

/// Posterior mean of a non-negative value that was measured as mean.value, with a normal error of
/// mean.deviation, under a uniform prior: the mean of a truncated normal distribution.
double not_below_zero(const Mean& mean)
{
    const double t = mean.value / mean.deviation;
    if (!std::isfinite(t) || t > 6) // no deviation, or far above 0
        return std::max(0.0, mean.value);
    if (t < -6)
        return -mean.deviation / t;
    const double density = std::exp(-0.5 * t * t) / std::sqrt(2 * pi),
                 above = 0.5 * std::erfc(-t / std::sqrt(2));
    return mean.value + mean.deviation * density / above;
}

Mean mean_of(const ErrorSums& sums, ErrorMethod method, double unsure)
{
    const double n = sums.pixels, mean = sums.sum / n;
    double variance = std::max(0.0, (sums.sum_of_squares - n * mean * mean) / (n - 1)) /
                      n; // of the mean
    if (method == ErrorMethod::split_halves)
        variance *= 2;
    const double deviation = std::sqrt(variance);
    return {mean, deviation, std::hypot(two_sided_95 * deviation, unsure * mean)};
}

} // namespace

std::optional<ErrorEstimate> estimate(const ErrorSums& sums, ErrorMethod method, double unsure)
{
    if (sums.pixels < 2)
        return std::nullopt;
    const Mean mean = mean_of(sums, method, unsure);
    ErrorSums once_more = sums;
    if (sums.largest > 0)
        once_more.add(sums.largest);
    const Mean upper = mean_of(once_more, method, unsure);

    ErrorEstimate result;
    result.method = method;
    result.pixels = sums.pixels;
    if (mean.value > mean.reach)
        result.low = std::sqrt(mean.value) * lower_bound_of_root(mean.reach / mean.value);
    if (upper.value > upper.reach)
        result.high = std::sqrt(upper.value) * std::exp(0.5 * upper.reach / upper.value);
    else // continuous with the branch above
        result.high = std::sqrt(std::max(0.0, upper.value + (std::exp(1.0) - 1) * upper.reach));
    result.rms = std::min(std::sqrt(not_below_zero(mean)), result.high);
    return result;
}

void add_independent(ErrorEstimate& error, const ErrorEstimate& other)
{
    error.rms = std::hypot(error.rms, other.rms);
    error.low = std::hypot(error.low, other.low);
    error.high = std::hypot(error.high, other.high);
    error.seconds += other.seconds;
}

} // namespace integral
