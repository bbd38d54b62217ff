// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/reconstruction.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace integral {

namespace {

// The expected squared error, divided by what the variance of the samples says, where nothing else
// is known, and the number of pixels as which that counts. Found by trying on sample scenes of
// POV-Ray's.
constexpr float usual_excess = 3, weight_of_usual = 8;

/// About exp(-x) for x >= 0; 0 from 8 on.
float fall_off(float x)
{
    float power = std::max(0.0f, 1 - x / 8);
    power *= power;
    power *= power;
    return power * power;
}

/// A colour's four components, side by side in a vector register (of GCC and Clang).
typedef float Components __attribute__((vector_size(16)));

Components components(const StoredColour& colour)
{
    typedef std::uint16_t Shorts __attribute__((vector_size(8)));
    typedef std::int32_t Integers __attribute__((vector_size(16)));
    Shorts shorts;
    std::memcpy(&shorts, &colour, sizeof shorts);
    return __builtin_convertvector(__builtin_convertvector(shorts, Integers), Components);
}

float squared_difference(Components a, Components b)
{
    const Components difference = a - b, squares = difference * difference;
    return ((squares[0] + squares[1]) + (squares[2] + squares[3])) *
           float(1 / (colour_levels * colour_levels));
}

/// A weighted mean of colours.
struct Sum {
    Components colour{};
    float weights = 0;
    void add(Components other, float weight)
    {
        weights += weight;
        colour += weight * other;
    }
    StoredColour mean() const
    {
        StoredColour mean;
        for (std::size_t k = 0; k < mean.size(); ++k)
            mean[k] = std::uint16_t(colour[k] / weights + 0.5f);
        return mean;
    }
};

} // namespace

int rows_compared(const LensSheet& sheet, const Film& film)
{
    return std::max(rows_looked_at(sheet, film), Reconstruction::risk_reach);
}

int rows_reconstructed_from(const LensSheet& sheet, const Film& film)
{
    return 2 * rows_compared(sheet, film) + Reconstruction::risk_reach;
}

int rows_antialiased_from(const LensSheet& sheet, const Film& film, int block_side)
{
    const int blocks = (rows_reconstructed_from(sheet, film) + block_side - 1) / block_side;
    return blocks * block_side + rows_looked_at(sheet, film);
}

bool Reconstruction::possible(const Film& film) { return film.subpixels.order == Subpixels::none; }

std::size_t Reconstruction::bytes(const Film& film)
{
    return bytes_a_pixel * film.width * film.height;
}

Reconstruction::Reconstruction(const IntegralCamera& camera, const FirstSamples& first,
                               double least_error, std::shared_ptr<void> memory)
    : first_(first),
      overlaps_(camera, first, rows_compared(camera.optics.sheet(), camera.film)),
      width_(camera.film.width),
      height_(camera.film.height),
      least_variance_(float(3 * least_error * least_error)),
      memory_(memory ? std::move(memory) : zeroed_memory(bytes(camera.film))),
      pixels_(static_cast<Pixel*>(memory_.get()))
{
}

void Reconstruction::set(int x, int y, const ComparedColour& mean, double variance,
                         double of_halves)
{
    Pixel& pixel = pixels_[index(x, y)];
    pixel.mean = stored_colour(mean);
    const bool clamped = *std::max_element(pixel.mean.begin(), pixel.mean.end()) == 65535;
    pixel.variance = clamped || !(variance >= 0) ? -1 : float(variance);
    pixel.of_halves = float(of_halves);
}

/// Calls visit(x, y, index) for the pixels behind the same lens at most `reach` pixels away, itself
/// included.
template <class Visit>
void Reconstruction::for_each_around(int x, int y, int reach, Visit visit) const
{
    const auto lens = *first_.lens(x, y);
    const int left = std::max(0, x - reach), right = std::min(width_ - 1, x + reach);
    for (int j = std::max(0, y - reach); j <= std::min(height_ - 1, y + reach); ++j)
        for (int i = left; i <= right; ++i)
            if (first_.is_behind(index(i, j), lens))
                visit(i, j, index(i, j));
}

/// The mean variance of the pixel and those beside it, times how much more the halves of the
/// samples around differ than their variance lets expect.
float Reconstruction::smooth_variance(int x, int y) const
{
    float near_sum = 0, expected = 0, seen = 0;
    int near_number = 0, number = 0;
    for_each_around(x, y, risk_reach, [&](int i, int j, std::size_t at) {
        const Pixel& other = pixels_[at];
        const float variance = std::max<float>(0, other.variance), of_halves = other.of_halves;
        if (std::abs(i - x) <= 1 && std::abs(j - y) <= 1) {
            near_sum += variance;
            ++near_number;
        }
        if (of_halves >= 0) {
            expected += variance;
            seen += of_halves;
            ++number;
        }
    });
    const float mean = near_sum / near_number;
    if (!(expected > 0))
        return usual_excess * mean;
    const float weight = weight_of_usual * expected / number;
    return mean * (seen + usual_excess * weight) / (expected + weight);
}

Reconstruction::Trial Reconstruction::trial(int x, int y, Scratch& scratch) const
{
    Trial result;
    const Pixel& own = pixels_[index(x, y)];
    const float variance = smooth_variance(x, y);
    if (own.variance < 0 || variance < least_variance_)
        return result;
    result.any = true;
    result.own_risk = variance;
    std::array<Sum, 2> sums;
    overlaps_.find(x, y, scratch);
    for (const BeamOverlaps::Overlap& overlap : scratch) {
        const Pixel& other = pixels_[overlap.pixel];
        if (other.variance < 0)
            continue;
        const Components mean = components(other.mean);
        sums[0].add(mean, overlap.narrow);
        sums[1].add(mean, overlap.wide);
    }
    for (int k = 0; k < 2; ++k) {
        result.colours[k] = sums[k].mean();
        result.risks[k] = squared_difference(components(result.colours[k]), components(own.mean)) -
                          variance + 2 * variance / sums[k].weights; // own overlap is 1
    }
    return result;
}

void Reconstruction::estimate(int left, int top, int right, int bottom)
{
    const int x0 = std::max(0, left - risk_reach), y0 = std::max(0, top - risk_reach),
              x1 = std::min(width_ - 1, right + risk_reach),
              y1 = std::min(height_ - 1, bottom + risk_reach);
    std::vector<Trial> trials(std::size_t(x1 - x0 + 1) * (y1 - y0 + 1));
    const auto trial_at = [&](int x, int y) -> Trial& {
        return trials[std::size_t(y - y0) * (x1 - x0 + 1) + (x - x0)];
    };
    Scratch scratch;
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x)
            if (first_.lens(x, y))
                trial_at(x, y) = trial(x, y, scratch);
    for (int y = top; y <= bottom; ++y)
        for (int x = left; x <= right; ++x) {
            Pixel& pixel = pixels_[index(x, y)];
            pixel.estimate = pixel.mean;
            const Trial& own = trial_at(x, y);
            if (!own.any)
                continue;
            float least = 0;
            std::array<float, 2> risks{};
            for_each_around(x, y, risk_reach, [&](int i, int j, std::size_t) {
                const Trial& other = trial_at(i, j);
                least += other.own_risk;
                for (int k = 0; k < 2; ++k)
                    risks[k] += other.risks[k];
            });
            for (int k = 0; k < 2; ++k)
                if (risks[k] < least) {
                    least = risks[k];
                    pixel.estimate = own.colours[k];
                }
        }
}

std::optional<ComparedColour> Reconstruction::reconstructed(int x, int y, Scratch& scratch) const
{
    const Pixel& own = pixels_[index(x, y)];
    if (!first_.lens(x, y) || own.variance < 0)
        return {};
    const float variance = smooth_variance(x, y);
    if (variance < least_variance_)
        return {};
    const Components own_estimate = components(own.estimate);
    const float by_variance = 1 / variance;
    Sum sum;
    overlaps_.find(x, y, scratch);
    for (const BeamOverlaps::Overlap& overlap : scratch) {
        const Pixel& other = pixels_[overlap.pixel];
        if (other.variance < 0)
            continue;
        const float likeness = fall_off(
            by_variance * squared_difference(components(other.estimate), own_estimate));
        sum.add(components(other.mean), overlap.wide * likeness);
    }
    return colour_of(sum.mean());
}

} // namespace integral
