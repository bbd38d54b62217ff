// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/similarity.h"

#include "integral/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

constexpr int reach = 5, window = 2 * reach + 1;
constexpr int moments = 5; // a window's means of a, b, a^2, b^2 and ab
constexpr int ring_rows = window + Similarity::most_rows;

/// Samples of a Gaussian of sigma 1.5, not normalised.
std::vector<double> gaussian_taps()
{
    std::vector<double> taps;
    for (int i = -reach; i <= reach; ++i)
        taps.push_back(std::exp(-i * i / (2 * 1.5 * 1.5)));
    return taps;
}

/// Calls add(i, tap) for each place i of [0, length) that the window around `centre` covers, in
/// order. Returns the sum of these taps.
template <class Add> double weigh(const std::vector<double>& taps, int centre, int length, Add add)
{
    double weight = 0;
    const int first = std::max(0, centre - reach), last = std::min(length - 1, centre + reach);
    for (int i = first; i <= last; ++i) {
        const double tap = taps[std::size_t(i - centre + reach)];
        add(i, tap);
        weight += tap;
    }
    return weight;
}

} // namespace

Similarity::Similarity(int width, int height, std::shared_ptr<const PixelWeights> weights)
    : width_(width),
      height_(height),
      left_(width >= window ? reach : 0),
      right_(width - left_),
      top_(height >= window ? reach : 0),
      bottom_(height - top_),
      taps_(gaussian_taps()),
      ring_(std::size_t(std::min(ring_rows, height)) * moments * std::size_t(right_ - left_)),
      weights_(std::move(weights))
{
}

/// The index in the ring at which one mean of row y begins.
std::size_t Similarity::place(int y, int moment) const
{
    const int row = y % std::min(ring_rows, height_);
    return (std::size_t(row) * moments + moment) * std::size_t(right_ - left_);
}

void Similarity::take_row(int y, const float* a, const float* b)
{
    const int across = right_ - left_;
    std::vector<double> values(std::size_t(moments) * width_);
    double* const v = values.data();
    for (int x = 0; x < width_; ++x) {
        v[x] = a[x];
        v[width_ + x] = b[x];
        v[2 * width_ + x] = double(a[x]) * a[x];
        v[3 * width_ + x] = double(b[x]) * b[x];
        v[4 * width_ + x] = double(a[x]) * b[x];
    }
    for (int k = 0; k < moments; ++k) {
        const double* from = v + std::size_t(k) * width_;
        double* to = ring_.data() + place(y, k);
        if (width_ < window) { // every window is cut, each at another place
            for (int x = 0; x < across; ++x) {
                double sum = 0;
                const auto add = [&](int i, double tap) { sum += tap * from[i]; };
                const double weight = weigh(taps_, x, width_, add);
                to[x] = sum / weight;
            }
            continue;
        }
        std::fill(to, to + across, 0.0);
        const double weight = weigh(taps_, reach, width_, [&](int i, double tap) {
            for (int x = 0; x < across; ++x)
                to[x] += tap * from[x + i];
        });
        for (int x = 0; x < across; ++x)
            to[x] /= weight;
    }
}

/// The SSIM of each window whose centre is in row y.
void Similarity::add_centres(int y, std::vector<double>& terms) const
{
    const int across = right_ - left_;
    std::vector<double> means(std::size_t(moments) * across);
    for (int k = 0; k < moments; ++k) {
        double* to = means.data() + std::size_t(k) * across;
        const double weight = weigh(taps_, y, height_, [&](int i, double tap) {
            const double* from = ring_.data() + place(i, k);
            for (int x = 0; x < across; ++x)
                to[x] += tap * from[x];
        });
        for (int x = 0; x < across; ++x)
            to[x] /= weight;
    }
    constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
    const double *a = means.data(), *b = a + across, *aa = b + across, *bb = aa + across,
                 *ab = bb + across;
    terms.resize(std::size_t(across));
    for (int x = 0; x < across; ++x) {
        const double variance_a = aa[x] - a[x] * a[x], variance_b = bb[x] - b[x] * b[x];
        const double covariance = ab[x] - a[x] * b[x];
        terms[std::size_t(x)] = (2 * a[x] * b[x] + c1) * (2 * covariance + c2) /
                                ((a[x] * a[x] + b[x] * b[x] + c1) * (variance_a + variance_b + c2));
    }
}

/// The weight of each window whose centre is in row y.
std::vector<float> Similarity::weights_of_centres(int y) const
{
    std::vector<float> weights(std::size_t(width_), 1.0f);
    if (weights_)
        weights_->fill(y, weights.data());
    return {weights.begin() + left_, weights.begin() + right_};
}

void Similarity::add(const float* a, const float* b, int rows)
{
    for_each_row(rows, 0, [&](int k) {
        const std::size_t at = std::size_t(k) * width_;
        take_row(taken_ + k, a + at, b + at);
    });
    taken_ += rows;
    const int first = std::max(top_, centred_);
    const int end = taken_ == height_ ? bottom_ : std::min(bottom_, taken_ - reach);
    if (end <= first)
        return;
    std::vector<std::vector<double>> terms(std::size_t(end - first));
    for_each_row(end - first, 0, [&](int k) { add_centres(first + k, terms[std::size_t(k)]); });
    // In order, so that the sum does not depend on the number of threads.
    for (int k = 0; k < end - first; ++k) {
        const auto weights = weights_of_centres(first + k);
        const auto& row = terms[std::size_t(k)];
        for (std::size_t x = 0; x < row.size(); ++x) {
            total_ += weights[x] * row[x];
            weight_ += weights[x];
        }
    }
    centred_ = end;
}

double Similarity::mean() const { return total_ / weight_; }

double structural_similarity(const std::vector<float>& a, const std::vector<float>& b, int width,
                             int height)
{
    Similarity similarity(width, height);
    for (int y = 0; y < height; y += Similarity::most_rows) {
        const std::size_t at = std::size_t(y) * width;
        similarity.add(a.data() + at, b.data() + at, std::min(Similarity::most_rows, height - y));
    }
    return similarity.mean();
}

} // namespace integral
