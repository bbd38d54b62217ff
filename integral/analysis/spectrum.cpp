// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/spectrum.h"

#include "integral/base/constants.h"
#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>

namespace integral {
namespace {

struct Free {
    void operator()(void* memory) const { fftw_free(memory); }
};

using Values = std::unique_ptr<double[], Free>;

/// The middle of a plane, width x height, less its mean and under a Hann window, in the top left
/// corner of a zero-filled raster of `size` rows of `padded` numbers.
Values windowed(const Plane& plane, int width, int height, int size, int padded)
{
    Values values(fftw_alloc_real(std::size_t(size) * padded));
    if (!values)
        throw std::bad_alloc();
    std::fill_n(values.get(), std::size_t(size) * padded, 0.0);
    const int left = (plane.width - width) / 2, top = (plane.height - height) / 2;
    double mean = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            mean += plane.at(left + x, top + y);
    mean /= std::max(1.0, double(width) * height);
    const auto window = [](int k, int length) {
        return 0.5 - 0.5 * std::cos(2 * pi * (k + 0.5) / length);
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            values[std::size_t(y) * padded + x] = window(x, width) * window(y, height) *
                                                  (plane.at(left + x, top + y) - mean);
    return values;
}

/// Transforms size x size real numbers in place, in FFTW's layout.
void transform(double* values, int size)
{
    const fftw_plan plan = fftw_plan_dft_r2c_2d(
        size, size, values, reinterpret_cast<fftw_complex*>(values), FFTW_ESTIMATE);
    if (!plan)
        throw std::bad_alloc();
    fftw_execute(plan);
    fftw_destroy_plan(plan);
}

/// Mean over each ring of frequencies and its neighbours.
std::vector<double> smoothed(const std::vector<double>& sums, const std::vector<double>& counts)
{
    constexpr int reach = 4;
    const int size = int(sums.size());
    std::vector<double> means(sums.size(), 0.0);
    for (int r = 0; r < size; ++r) {
        double sum = 0, count = 0;
        for (int k = std::max(0, r - reach); k <= std::min(size - 1, r + reach); ++k) {
            sum += sums[k];
            count += counts[k];
        }
        means[r] = count > 0 ? sum / count : 0;
    }
    return means;
}

} // namespace

Spectrum::Spectrum(const Plane& plane, int most) : size_(2), extent_(0)
{
    const int width = std::min(plane.width, most), height = std::min(plane.height, most);
    extent_ = std::min(width, height);
    while (size_ < 2 * std::max(width, height)) // bins of half the window's resolution
        size_ *= 2;
    const int columns = size_ / 2 + 1, padded = 2 * columns;
    const Values values = windowed(plane, width, height, size_, padded);
    transform(values.get(), size_);
    const auto* frequencies = reinterpret_cast<const fftw_complex*>(values.get());

    power_.resize(std::size_t(size_) * columns);
    std::vector<double> sums(size_, 0.0), counts(size_, 0.0); // by ring
    const auto ring = [&](int x, int y) {
        return int(std::lround(std::hypot(x, y <= size_ / 2 ? y : y - size_)));
    };
    for (int y = 0; y < size_; ++y)
        for (int x = 0; x < columns; ++x) {
            const std::size_t k = std::size_t(y) * columns + x;
            power_[k] = float(frequencies[k][0] * frequencies[k][0] +
                              frequencies[k][1] * frequencies[k][1]);
            sums[ring(x, y)] += power_[k];
            counts[ring(x, y)] += 1;
        }
    const std::vector<double> means = smoothed(sums, counts);
    for (int y = 0; y < size_; ++y)
        for (int x = 0; x < columns; ++x) {
            const double level = means[ring(x, y)];
            float& value = power_[std::size_t(y) * columns + x];
            value = level > 0 ? float(value / level) : 0;
        }
}

double Spectrum::power(Vec2 frequency) const
{
    if (frequency.x < 0)
        frequency = -1.0 * frequency; // the spectrum of real numbers is symmetric
    if (!(frequency.x < 0.5 && std::fabs(frequency.y) < 0.5))
        return 0;
    const double x = frequency.x * size_, y = frequency.y * size_;
    const int left = int(x), top = int(std::floor(y));
    double sum = 0;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            const double weight = (i ? x - left : 1 - (x - left)) * (j ? y - top : 1 - (y - top));
            sum += weight *
                   power_[std::size_t((top + j + size_) % size_) * (size_ / 2 + 1) + left + i];
        }
    return sum;
}

} // namespace integral
