// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/plot_axis.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace integral {
namespace {

constexpr double largest_shown = 1e300; // the width of a larger range overflows
constexpr double rounding = 1e-9;       // part of a step by which a value may miss a tick
const double mantissas[] = {1, 2, 5};

double step_of(int exponent, int mantissa)
{
    return mantissas[mantissa] * std::pow(10.0, exponent);
}

std::string number(double value, int decimals)
{
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, std::fabs(value));
    return (value < 0 ? "\u2212" : "") + std::string(text);
}

std::string exponent_text(int exponent)
{
    return (exponent < 0 ? "\u2212" : "") + std::to_string(std::abs(exponent));
}

/// The tick at `value`, a whole number of steps of mantissa * 10^exponent.
PlotTick linear_tick(double value, double largest, int exponent)
{
    PlotTick tick{value, "", ""};
    if (value == 0)
        tick.label = "0";
    else if (largest < 1e6 && exponent >= -5)
        tick.label = number(value, std::max(0, -exponent));
    else {
        // For example 12.5·10^7: all ticks use the power of ten of the largest tick.
        const int power = static_cast<int>(std::floor(std::log10(largest) + 1e-12));
        tick.label = number(value / std::pow(10.0, power), std::max(0, power - exponent)) +
                     "\u00b710";
        tick.exponent = exponent_text(power);
    }
    return tick;
}

/// Widens an empty range so that its only value is in the middle.
void open_linear(double& low, double& high, bool low_given, bool high_given)
{
    const double size = std::max(std::fabs(low), std::fabs(high));
    if (high - low > 1e-12 * size)
        return;
    const double room = size > 0 ? 0.1 * size : 1;
    if (!low_given)
        low = high - room;
    if (!high_given)
        high = (low_given ? low : high) + room;
}

void scale_linear(PlotScale& scale, bool low_given, bool high_given, int most_labels)
{
    open_linear(scale.low, scale.high, low_given, high_given);
    const double span = scale.high - scale.low;
    int exponent = static_cast<int>(std::floor(std::log10(span / most_labels))) - 1, mantissa = 0;
    const auto first = [&] {
        return std::floor(scale.low / step_of(exponent, mantissa) + rounding);
    };
    const auto last = [&] {
        return std::ceil(scale.high / step_of(exponent, mantissa) - rounding);
    };
    while (last() - first() + 1 > most_labels) {
        mantissa = (mantissa + 1) % 3;
        exponent += mantissa == 0;
    }
    const double step = step_of(exponent, mantissa);
    const auto tick_value = [&](double index) { // rounds like the decimal number
        return exponent < 0 ? index * mantissas[mantissa] / std::pow(10.0, -exponent)
                            : index * step;
    };
    const double begin = first(), end = last();
    if (!low_given)
        scale.low = std::min(scale.low, tick_value(begin));
    if (!high_given)
        scale.high = std::max(scale.high, tick_value(end));
    const double largest = std::max(std::fabs(scale.low), std::fabs(scale.high));
    for (double index = begin; index <= end; ++index)
        if (const double value = tick_value(index); scale.contains(value))
            scale.ticks.push_back(linear_tick(value, largest, exponent));
}

PlotTick logarithmic_tick(int exponent, int digit)
{
    PlotTick tick{digit * std::pow(10.0, exponent), "", ""};
    if (exponent < 0)
        tick.value = digit / std::pow(10.0, -exponent);
    if (exponent >= -3 && exponent <= 4)
        tick.label = number(tick.value, std::max(0, -exponent));
    else {
        tick.label = digit == 1 ? "10" : std::to_string(digit) + "\u00b710";
        tick.exponent = exponent_text(exponent);
    }
    return tick;
}

/// Rounds outwards to a 1-2-5 step.
double rounded_log(double value, bool up)
{
    const int exponent = static_cast<int>(std::floor(std::log10(value) + rounding));
    double result = std::pow(10.0, exponent + up);
    for (const double mantissa : mantissas) {
        const double step = mantissa * std::pow(10.0, exponent);
        if (up ? step >= value * (1 - rounding) && step < result : step <= value * (1 + rounding))
            result = step;
    }
    return result;
}

void scale_logarithmic(PlotScale& scale, bool low_given, bool high_given, int most_labels)
{
    if (!(scale.high > scale.low * (1 + 1e-9))) {
        if (!low_given)
            scale.low = scale.high / 2;
        if (!high_given)
            scale.high = 2 * (low_given ? scale.low : scale.high);
    }
    if (!low_given)
        scale.low = rounded_log(scale.low, false);
    if (!high_given)
        scale.high = rounded_log(scale.high, true);
    const int first = static_cast<int>(std::floor(std::log10(scale.low) + rounding));
    const int last = static_cast<int>(std::floor(std::log10(scale.high) + rounding));
    const double decades = std::log10(scale.high) - std::log10(scale.low);
    const int every = static_cast<int>(std::ceil(decades / most_labels));
    const bool halves = 3 * decades <= most_labels; // room to label 2 and 5
    const bool all = 22 * decades <= most_labels;   // the step from 9 to 10 is 1/22 of a decade
    for (int exponent = first; exponent <= last; ++exponent)
        for (int digit = 1; digit <= 9; ++digit) {
            PlotTick tick = logarithmic_tick(exponent, digit);
            if (!scale.contains(tick.value) || (digit > 1 && every > 1))
                continue;
            const bool labelled = digit == 1 ? (exponent - first) % every == 0
                                             : all || (halves && (digit == 2 || digit == 5));
            if (!labelled)
                tick.label = tick.exponent = "";
            scale.ticks.push_back(tick);
        }
}

} // namespace

bool PlotScale::showable(double value) const
{
    return std::fabs(value) <= largest_shown && (!logarithmic || value >= 1 / largest_shown);
}

double PlotScale::part(double value) const
{
    if (logarithmic)
        return (std::log(value) - std::log(low)) / (std::log(high) - std::log(low));
    return (value - low) / (high - low);
}

bool PlotScale::contains(double value) const
{
    return showable(value) && part(value) >= -rounding && part(value) <= 1 + rounding;
}

PlotScale make_scale(const PlotAxis& axis, const std::vector<double>& values, int most_labels)
{
    PlotScale scale;
    scale.logarithmic = axis.logarithmic;
    for (const auto& end : {axis.low, axis.high})
        if (end && !scale.showable(*end))
            throw std::invalid_argument("an end of the plot's axis " + axis.label +
                                        " has no place on it");
    if (axis.low && axis.high && !(*axis.low < *axis.high))
        throw std::invalid_argument("the range of the plot's axis " + axis.label + " is empty");
    std::optional<double> low = axis.low, high = axis.high;
    for (const double value : values)
        if (scale.showable(value)) {
            if (!axis.low)
                low = std::min(low.value_or(value), value);
            if (!axis.high)
                high = std::max(high.value_or(value), value);
        }
    if (!low && !high)
        low = scale.logarithmic ? 1 : 0;
    scale.low = low ? *low : *high;
    scale.high = high ? *high : *low;
    if (axis.low)
        scale.high = std::max(scale.high, scale.low);
    else
        scale.low = std::min(scale.low, scale.high);
    if (scale.logarithmic)
        scale_logarithmic(scale, axis.low.has_value(), axis.high.has_value(), most_labels);
    else
        scale_linear(scale, axis.low.has_value(), axis.high.has_value(), most_labels);
    return scale;
}

} // namespace integral
