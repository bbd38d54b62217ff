// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/views/deghost.h"

#include "integral/base/constants.h"
#include "integral/replay/arrange.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

constexpr int iterations = 60;
constexpr float most_ghost = 0.03f; // beyond this, an eye is at the border of two pictures
constexpr float at_borders = 0.02f; // weight of errors there

/// The fraction of a disc of radius 1 that lies to the left of x.
double part_of_disc(double x)
{
    if (x <= -1)
        return 0;
    if (x >= 1)
        return 1;
    return 0.5 + (x * std::sqrt(1 - x * x) + std::asin(x)) / pi;
}

/// The fractions of an eye's light that come from the pixel in the middle of what it sees behind a
/// lens, and from the neighbours on one side. `spot` and `pupil`: radii of the two discs over which
/// the eye gathers light, in pixels.
std::vector<float> weights_of(double spot, double pupil)
{
    constexpr int places = 64; // of the pupil
    const auto left_of = [&](double x) {
        return spot > 0 ? part_of_disc(x / spot) : x > 0 ? 1.0 : x < 0 ? 0.0 : 0.5;
    };
    std::vector<float> weights;
    for (int k = 0; k <= int(std::ceil(spot + pupil)); ++k) {
        double sum = 0, all = 0;
        for (int j = 0; j < places; ++j) {
            const double x = (2 * j + 1.0) / places - 1, weight = std::sqrt(1 - x * x);
            sum += weight * (left_of(k + 0.5 - x * pupil) - left_of(k - 0.5 - x * pupil));
            all += weight;
        }
        weights.push_back(float(sum / all));
    }
    return weights;
}

} // namespace

Deghosting::Deghosting(const FrameMetadata& geometry, double contrast, ZoneAxis axis)
    : contrast_(contrast), axis_(axis)
{
    View view;
    view.eye = centre_eye(geometry);
    set_as_seen(view, geometry);
    const bool up = axis == ZoneAxis::upwards;
    const Vec2 zone = viewing_zone(geometry, geometry.aperture.distance),
               cell = cell_extent(geometry.sheet), pixel = geometry.film.pixel_pitch;
    const double film_of_zone = up ? cell.y / zone.y : cell.x / zone.x,
                 pitch = up ? pixel.y : pixel.x;
    weights_ = weights_of(0.5 * view.blur / pitch, 0.5 * view.pupil * film_of_zone / pitch);
    // A pixel farther away changes the light by less than 3e-4 (measured on random steps).
    reach_ = 8 * int(weights_.size());
}

void Deghosting::mix(const std::vector<float>& line, std::vector<float>& mixed) const
{
    const int size = int(line.size()), most = int(weights_.size()) - 1;
    mixed.resize(line.size());
    for (int i = 0; i < size; ++i) {
        float sum = weights_[0] * line[i];
        for (int k = 1; k <= most; ++k)
            sum += weights_[k] * (line[std::max(0, i - k)] + line[std::min(size - 1, i + k)]);
        mixed[i] = sum;
    }
}

void Deghosting::apply(Work& work) const
{
    auto& [line, wanted, counts, mixed, errors] = work;
    for (float& light : line)
        light = float(with_less_contrast(light));
    wanted = line;
    mix(wanted, mixed);
    counts.resize(line.size());
    for (std::size_t i = 0; i < line.size(); ++i)
        counts[i] = std::fabs(wanted[i] - mixed[i]) <= most_ghost ? 1 : at_borders;
    errors.resize(line.size());
    for (int step = 0; step < iterations; ++step) {
        mix(line, mixed);
        for (std::size_t i = 0; i < line.size(); ++i)
            errors[i] = counts[i] * (wanted[i] - mixed[i]);
        mix(errors, mixed);
        for (std::size_t i = 0; i < line.size(); ++i)
            line[i] = std::clamp(line[i] + mixed[i], 0.0f, 1.0f);
    }
}

void Deghosting::apply(Image& light, int threads) const
{
    auto& samples = std::get<std::vector<float>>(light.samples);
    const bool up = axis_ == ZoneAxis::upwards;
    const std::size_t across = std::size_t(light.channels), row = across * std::size_t(light.width),
                      step = up ? row : across;
    const int lines = up ? light.width : light.height, length = up ? light.height : light.width;
    for_each_row(lines, threads, [&](int k) {
        Work work;
        std::vector<float>& line = work.line;
        line.resize(std::size_t(length));
        for (int channel = 0; channel < 3; ++channel) {
            float* const first = samples.data() + std::size_t(k) * (up ? across : row) + channel;
            for (int i = 0; i < length; ++i)
                line[i] = first[i * step];
            apply(work);
            for (int i = 0; i < length; ++i)
                first[i * step] = line[i];
        }
    });
}

} // namespace integral
