// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/flip_kernels.h"

#include "integral/base/constants.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace integral {
namespace {

/// exp(-pi^2 x^2 / b) at the pixels' places in degrees: the inverse Fourier transform of a Gaussian
/// of the eye's contrast sensitivity, exp(-b f^2), without its factor (equation 3).
std::vector<double> sensitivity(double b, int radius, double ppd)
{
    std::vector<double> values;
    for (int i = -radius; i <= radius; ++i)
        values.push_back(std::exp(-pi * pi * (i / ppd) * (i / ppd) / b));
    return values;
}

double sum_of(const std::vector<double>& values)
{
    double sum = 0;
    for (const double value : values)
        sum += value;
    return sum;
}

/// Values times a factor, without values at the ends that are too small to change a float.
FlipTaps taps_of(const std::vector<double>& values, double factor)
{
    double greatest = 0;
    for (const double value : values)
        greatest = std::max(greatest, std::fabs(value));
    int radius = int(values.size()) / 2;
    const int middle = radius;
    while (radius > 0 && std::fabs(values[std::size_t(middle - radius)]) < 1e-9 * greatest)
        --radius;
    FlipTaps taps;
    taps.radius = radius;
    for (int i = -radius; i <= radius; ++i)
        taps.values.push_back(float(factor * values[std::size_t(middle + i)]));
    return taps;
}

/// Values scaled so that the positive ones add up to 1 and the negative ones to -1 (section 4.2.1).
FlipTaps detector_taps(std::vector<double> values)
{
    double positive = 0, negative = 0;
    for (const double value : values)
        (value > 0 ? positive : negative) += value;
    for (double& value : values)
        value /= value > 0 ? positive : -negative;
    return taps_of(values, 1);
}

// ACES' filmic curve as Narkowicz fits it, with his exposure of 0.6: (a x^2 + b x)/(c x^2 + d x +
// e).
constexpr double aces_a = 0.6 * 0.6 * 2.51, aces_b = 0.6 * 0.03, aces_c = 0.6 * 0.6 * 2.43,
                 aces_d = 0.6 * 0.59, aces_e = 0.14;

/// The light that the tone mapper shows at 0.85 of full scale.
double well_exposed()
{
    const double shown = 0.85;
    const double a = aces_a - shown * aces_c, b = aces_b - shown * aces_d, c = -shown * aces_e;
    return (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
}

std::uint32_t bits_of(float value)
{
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

float float_of(std::uint32_t bits)
{
    float value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

constexpr int dropped_bits = 9; // leaves 14 bits of a float's mantissa: steps of 6e-5

} // namespace

FlipKernels flip_kernels(double ppd)
{
    FlipKernels kernels;
    // Table 1: contrast sensitivity a1 exp(-b1 f^2) + a2 exp(-b2 f^2), f in cycles per degree.
    constexpr double luminance_b = 0.0047, red_green_b = 0.0053;
    constexpr double blue_yellow_a[] = {34.1, 13.5}, blue_yellow_b[] = {0.04, 0.025};
    // Three standard deviations of the widest filter.
    const int radius = int(std::ceil(3 * std::sqrt(blue_yellow_b[0] / (2 * pi * pi)) * ppd));
    const auto alone = [&](double b) {
        const auto values = sensitivity(b, radius, ppd);
        return taps_of(values, 1 / sum_of(values));
    };
    kernels.luminance = alone(luminance_b);
    kernels.red_green = alone(red_green_b);
    double weights[2], total = 0;
    std::vector<double> values[2];
    for (int k = 0; k < 2; ++k) {
        values[k] = sensitivity(blue_yellow_b[k], radius, ppd);
        weights[k] = blue_yellow_a[k] * std::sqrt(pi / blue_yellow_b[k]);
        total += weights[k] * sum_of(values[k]) * sum_of(values[k]);
    }
    for (int k = 0; k < 2; ++k)
        kernels.blue_yellow[k] = taps_of(values[k], std::sqrt(weights[k] / total));

    // Section 4.2.1: a feature's width is 0.082 degrees, twice the Gaussian's standard deviation.
    const double deviation = 0.5 * 0.082 * ppd;
    const int reach = int(std::ceil(3 * deviation));
    std::vector<double> smooth, edge, point;
    for (int i = -reach; i <= reach; ++i) {
        const double gaussian = std::exp(-i * i / (2 * deviation * deviation));
        smooth.push_back(gaussian);
        edge.push_back(-i * gaussian);
        point.push_back((i * i / (deviation * deviation) - 1) * gaussian);
    }
    kernels.smooth = taps_of(smooth, 1 / sum_of(smooth));
    kernels.edge = detector_taps(edge);
    kernels.point = detector_taps(point);
    for (const FlipTaps* taps :
         {&kernels.luminance, &kernels.red_green, &kernels.blue_yellow[0], &kernels.blue_yellow[1],
          &kernels.smooth, &kernels.edge, &kernels.point})
        kernels.radius = std::max(kernels.radius, taps->radius);
    return kernels;
}

double FlipExposures::at(int index) const
{
    return count > 1 ? start + index * (stop - start) / (count - 1) : start;
}

FlipExposureMeter::FlipExposureMeter()
    : counts_((bits_of(std::numeric_limits<float>::max()) >> dropped_bits) + 1)
{
}

void FlipExposureMeter::add(float luminance)
{
    if (!(luminance > 0 && std::isfinite(luminance))) {
        ++dark_;
        return;
    }
    ++bright_;
    ++counts_[bits_of(luminance) >> dropped_bits];
    greatest_ = std::max(greatest_, luminance);
}

FlipExposures FlipExposureMeter::exposures() const
{
    if (bright_ == 0)
        return {0, 0, 1};
    // The median's rank among pixels that are not dark, in the middle of the median's pixel.
    const double rank = dark_ > bright_ ? bright_ / 2.0 : (bright_ - double(dark_)) / 2.0;
    double below = 0, median = greatest_;
    for (std::size_t k = 0; k < counts_.size(); ++k) {
        if (below + counts_[k] >= rank && counts_[k] > 0) {
            const double low = float_of(std::uint32_t(k) << dropped_bits),
                         high = float_of((std::uint32_t(k) + 1) << dropped_bits);
            median = low + (rank - below) / counts_[k] * (high - low);
            break;
        }
        below += counts_[k];
    }
    FlipExposures exposures;
    exposures.start = std::log2(well_exposed() / greatest_);
    exposures.stop = std::log2(well_exposed() / std::min(median, double(greatest_)));
    exposures.count = int(std::max(2.0, std::ceil(exposures.stop - exposures.start)));
    return exposures;
}

const FlipMatrices& flip_matrices()
{
    static const FlipMatrices matrices = [] {
        // Chromaticities of sRGB's primaries and white (IEC 61966-2-1).
        const double x[3] = {0.64, 0.30, 0.15}, y[3] = {0.33, 0.60, 0.06};
        const double white[3] = {0.3127 / 0.3290, 1, (1 - 0.3127 - 0.3290) / 0.3290};
        double p[3][3]; // columns: XYZ of a primary of luminance 1, in units of the white's
        for (int k = 0; k < 3; ++k) {
            p[0][k] = x[k] / y[k] / white[0];
            p[1][k] = 1;
            p[2][k] = (1 - x[k] - y[k]) / y[k] / white[2];
        }
        const auto inverse_of = [](const double m[3][3], double inverse[3][3]) {
            double determinant = 0;
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) {
                    const int r = (i + 1) % 3, s = (i + 2) % 3, t = (j + 1) % 3, u = (j + 2) % 3;
                    inverse[j][i] = m[r][t] * m[s][u] - m[r][u] * m[s][t];
                    if (i == 0)
                        determinant += m[0][j] * inverse[j][0];
                }
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j)
                    inverse[i][j] /= determinant;
        };
        FlipMatrices result;
        double inverse[3][3];
        inverse_of(p, inverse);
        // White is the sum of the primaries: scales each by its share.
        for (int k = 0; k < 3; ++k) {
            const double share = inverse[k][0] + inverse[k][1] + inverse[k][2];
            for (int i = 0; i < 3; ++i)
                result.relative_from_rgb[i][k] = p[i][k] * share;
        }
        inverse_of(result.relative_from_rgb, result.rgb_from_relative);
        return result;
    }();
    return matrices;
}

} // namespace integral
