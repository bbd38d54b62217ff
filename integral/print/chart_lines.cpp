// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/print/chart_lines.h"

#include <algorithm>
#include <cmath>

namespace integral {

namespace {

/// Integral from 0 to u of a wave of period 1 (the lines' light minus its mean). The wave is
/// 1 - share within share/2 of every whole number, and -share elsewhere.
double first_integral(double u, double share)
{
    u -= std::floor(u + 0.5 * share);
    return u <= 0.5 * share ? (1 - share) * u : share * (0.5 - u);
}

/// Integral of first_integral.
double second_integral(double u, double share)
{
    u -= std::floor(u + 0.5 * share);
    return u <= 0.5 * share ? 0.5 * (1 - share) * u * u
                            : share * ((1 - share) / 8 - (u - 0.5) * (u - 0.5) / 2);
}

} // namespace

std::vector<ChartDirection> chart_directions(const LensSheet& sheet)
{
    const Lattice lattice(sheet);
    const auto direction = [&](Vec2 wave, double share) {
        const bool upright = std::fabs(wave.y) > std::fabs(wave.x) * (1 + 1e-9);
        if ((upright ? wave.y : wave.x) < 0)
            wave = -1.0 * wave;
        return ChartDirection{wave, share, upright};
    };
    if (sheet.arrangement == Arrangement::lenticular)
        return {direction(lattice.across(), 1)};
    if (sheet.arrangement == Arrangement::square)
        return {direction(lattice.across(), 1), direction(lattice.along(), 1)};
    // The lenses of neighbouring rows are shifted by half a pitch along the rows. Lines half a
    // pitch apart look the same under all rows.
    return {direction(lattice.across(), 0.5), direction(lattice.along(), std::sqrt(0.75))};
}

double pixel_along(Vec2 wave, const Film& film)
{
    return std::max(std::fabs(wave.x) * film.pixel_pitch.x, std::fabs(wave.y) * film.pixel_pitch.y);
}

double line_coverage(double phase, double a, double b, double share)
{
    const auto first = [&](double u) { return first_integral(u, share); };
    const auto second = [&](double u) { return second_integral(u, share); };
    if (a < b)
        std::swap(a, b);
    double mean;
    if (b < 1e-7) // the second difference of nearly equal numbers would lose all digits
        mean = (first(phase + a) - first(phase - a)) / (2 * a);
    else
        mean = (second(phase + a + b) - second(phase + a - b) - second(phase - a + b) +
                second(phase - a - b)) /
               (4 * a * b);
    return std::clamp(share + mean, 0.0, 1.0);
}

void draw_lines(const Film& film, const ChartLines& bar, Image& image)
{
    const double a = std::fabs(bar.wave.x) * film.pixel_pitch.x / 2 / bar.period,
                 b = std::fabs(bar.wave.y) * film.pixel_pitch.y / 2 / bar.period;
    for (int y = 0; y < bar.height; ++y)
        for (int x = 0; x < bar.width; ++x) {
            const bool second = bar.halves &&
                                (bar.upright ? x >= bar.width / 2 : y >= bar.height / 2);
            const Vec2 place = film_from_pixel(film, {bar.left + x + 0.5, bar.top + y + 0.5}) -
                               bar.origin;
            const float light = float(line_coverage(
                dot(bar.wave, place) / bar.period - (second ? 0.25 : 0), a, b, bar.light_share));
            store_linear(image, bar.left + x, bar.top + y, {light, light, light, 1});
        }
}

} // namespace integral
