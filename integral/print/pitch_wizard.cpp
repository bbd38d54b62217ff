// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/print/pitch_wizard.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace integral {
namespace {

constexpr double least_ior = 1, greatest_ior = 4;
constexpr double same_distance = 1e-6; // relative difference up to which distances are the same

std::string text_of(double value)
{
    std::ostringstream text;
    text.precision(4);
    text << value;
    return text.str();
}

/// One reading as a point of the line q = p + (p t/n) x.
struct Point {
    double x; ///< 1/distance
    Measured q;
};

/// A line fitted to points: its value at x = 0 and its slope. Each is the sum of the points' q
/// times these weights.
struct Line {
    double at_zero = 0, slope = 0;
    std::vector<double> zero_weights, slope_weights;
};

/// Fits by least squares, weighted by 1/error^2. The points' x must not all be equal.
Line fit(const std::vector<Point>& points)
{
    double w = 0, wx = 0;
    for (const Point& p : points) {
        const double weight = 1 / (p.q.error * p.q.error);
        w += weight;
        wx += weight * p.x;
    }
    const double mean = wx / w;
    double spread = 0;
    for (const Point& p : points)
        spread += (p.x - mean) * (p.x - mean) / (p.q.error * p.q.error);
    Line line;
    for (const Point& p : points) {
        const double weight = 1 / (p.q.error * p.q.error);
        line.slope_weights.push_back(weight * (p.x - mean) / spread);
        line.zero_weights.push_back(weight / w - mean * line.slope_weights.back());
        line.slope += line.slope_weights.back() * p.q.value;
        line.at_zero += line.zero_weights.back() * p.q.value;
    }
    return line;
}

/// Throws std::invalid_argument if a reading is farther from the line than twice the reading's
/// error bound.
void check_agreement(const std::vector<Point>& points, double at_zero, double slope,
                     const PitchScale& scale, const char* help)
{
    for (const Point& p : points) {
        const double off = p.q.value - (at_zero + slope * p.x);
        if (std::fabs(off) > 2 * p.q.error * (1 + 1e-9))
            throw std::invalid_argument(
                "the readings contradict one another: that from " + text_of(1 / p.x) + " mm is " +
                text_of(std::fabs(off) / scale.step) + " bars from what all of them give; " + help);
    }
}

MeasuredSheet with_known_index(const LensSheet& sheet, const PitchScale& scale,
                               const std::vector<Point>& points)
{
    double weights = 0;
    MeasuredSheet result;
    for (const Point& p : points) {
        const double bias = 1 + sheet.thickness / sheet.ior * p.x,
                     weight = bias * bias / (p.q.error * p.q.error);
        weights += weight;
        result.pitch.value += weight * (p.q.value / bias);
        result.pitch.error += weight * (p.q.error / bias);
    }
    result.pitch.value /= weights;
    result.pitch.error /= weights;
    result.index = {sheet.ior, 0};
    result.least_index = result.greatest_index = sheet.ior;
    check_agreement(points, result.pitch.value, result.pitch.value * sheet.thickness / sheet.ior,
                    scale, "read them again, or let the index be measured too");
    return result;
}

/// Throws std::invalid_argument, as no sheet has the measured index. `least`: the minimum index
/// that the readings allow.
[[noreturn]] void refuse_index(const LensSheet& sheet, const MeasuredSheet& result, double least)
{
    const std::string reach = " (" + text_of(least) +
                              (result.greatest_index > 0 ? " to " + text_of(result.greatest_index)
                                                         : std::string(" or more")) +
                              ")";
    throw std::invalid_argument("the readings give an index of " + text_of(result.index.value) +
                                reach + " for a thickness of " + text_of(sheet.thickness) +
                                " mm, and it must be within " + text_of(least_ior) + " and " +
                                text_of(greatest_ior) +
                                "; read again from distances farther apart, or keep the index");
}

MeasuredSheet with_measured_index(const LensSheet& sheet, const PitchScale& scale,
                                  const std::vector<Point>& points)
{
    const auto by_x = [](const Point& a, const Point& b) { return a.x < b.x; };
    const auto [far, near] = std::minmax_element(points.begin(), points.end(), by_x);
    if (near->x - far->x <= same_distance * near->x)
        throw std::invalid_argument("the readings are all from " + text_of(1 / near->x) +
                                    " mm, which does not tell the index; read from another "
                                    "distance as well, or keep the index");
    const Line line = fit(points);
    if (!(line.slope > 0))
        throw std::invalid_argument("the readings contradict the optics: the bar that looks even "
                                    "must have a smaller pitch from farther away; "
                                    "read them again, or keep the index");
    check_agreement(points, line.at_zero, line.slope, scale, "read them again");

    MeasuredSheet result;
    result.index_measured = true;
    const double depth = line.slope / line.at_zero; // t/n
    double depth_error = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        result.pitch.error += std::fabs(line.zero_weights[i]) * points[i].q.error;
        depth_error += std::fabs(line.slope_weights[i] - depth * line.zero_weights[i]) /
                       line.at_zero * points[i].q.error;
    }
    result.pitch.value = line.at_zero;
    result.index.value = sheet.thickness / depth;
    result.index.error = result.index.value * depth_error / depth;
    result.least_index = std::max(least_ior, sheet.thickness / (depth + depth_error));
    result.greatest_index = depth > depth_error ? sheet.thickness / (depth - depth_error) : 0;
    if (!(result.index.value >= least_ior && result.index.value <= greatest_ior))
        refuse_index(sheet, result, sheet.thickness / (depth + depth_error));
    return result;
}

} // namespace

double film_pitch(const PitchScale& scale, int bar)
{
    return scale.first + (bar - 1) % scale.bars * scale.step;
}

double bar_of_pitch(const PitchScale& scale, double pitch)
{
    return 1 + (pitch - scale.first) / scale.step;
}

Measured film_pitch_of(const PitchScale& scale, const ChartReading& reading)
{
    if (reading.bars.empty())
        throw std::invalid_argument("a reading has no bar");
    double sum = 0, least = 0, greatest = 0;
    for (std::size_t i = 0; i < reading.bars.size(); ++i) {
        const int bar = reading.bars[i];
        if (bar < 1 || bar > 2 * scale.bars)
            throw std::invalid_argument("bar " + std::to_string(bar) + " is not on a chart of " +
                                        std::to_string(scale.bars) + " bars");
        const double pitch = film_pitch(scale, bar);
        sum += pitch;
        least = i == 0 ? pitch : std::min(least, pitch);
        greatest = i == 0 ? pitch : std::max(greatest, pitch);
    }
    if (greatest - least > (double(reading.bars.size()) - 0.5) * scale.step)
        throw std::invalid_argument("bars of one reading must be neighbours; read the bar, or the "
                                    "neighbours, with the fewest bands");
    return {sum / double(reading.bars.size()), std::max(scale.step, greatest - least) / 2};
}

MeasuredSheet measured_sheet(const LensSheet& sheet, const PitchScale& scale,
                             const std::vector<ChartReading>& readings, bool keep_index)
{
    if (readings.empty())
        throw std::invalid_argument("there is no reading");
    std::vector<Point> points;
    for (const ChartReading& reading : readings) {
        if (!(reading.distance > 0 && std::isfinite(reading.distance)))
            throw std::invalid_argument("a distance must be greater than 0");
        points.push_back({1 / reading.distance, film_pitch_of(scale, reading)});
    }
    return keep_index || readings.size() == 1 ? with_known_index(sheet, scale, points)
                                              : with_measured_index(sheet, scale, points);
}

} // namespace integral
