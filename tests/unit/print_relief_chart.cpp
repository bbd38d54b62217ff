// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the chart for printed lenses with lenses that are displaced or of a wrong pitch: the chart
// must show it. The rays follow Snell's law, computed here.
#include "integral/print/relief_chart.h"

#include "integral/optics/lens_sheet.h"

#include <boost/test/unit_test.hpp>
#include <cmath>

using namespace integral;

namespace {

ReliefChart chart_of(Arrangement arrangement, double slant)
{
    ReliefChart chart;
    chart.sheet.arrangement = arrangement;
    chart.sheet.pitch = 0.7;
    chart.sheet.thickness = 2;
    chart.sheet.ior = 1.5;
    chart.sheet.slant = slant;
    chart.film.pixel_pitch = {25.4 / 300, 25.4 / 300};
    chart.film.width = arrangement == Arrangement::lenticular ? 1000 : 1900;
    chart.film.height = 1100;
    return chart;
}

/// The light that the lenses over a bar show to the eye above the page's middle, and how much it
/// differs along the bar: the standard deviation of the means of eight parts.
struct Seen {
    double light = 0, unevenness = 0;
};

Seen seen(const ReliefChart& chart, const Image& picture, const ReliefBar& bar,
          const LensSheet& printed)
{
    const Lattice lattice(printed);
    const LinearReader light(picture);
    const Film& film = chart.film;
    std::array<double, 8> sums{}, numbers{};
    for (int y = bar.top; y < bar.top + bar.height; y += 3)
        for (int x = bar.left; x < bar.left + bar.width; x += 4) {
            // The point of the film that the eye sees through the lens nearest to this place.
            const Vec2 place = film_from_pixel(film, {x + 0.5, y + 0.5});
            const LensIndex lens = lattice.nearest(place);
            Vec2 pole = lattice.pole(lens);
            if (printed.arrangement == Arrangement::lenticular)
                pole = pole + dot(place - pole, lattice.along()) * lattice.along();
            const double r = length(pole), sine = r / std::hypot(r, chart.distance) / printed.ior;
            const double way = printed.thickness * sine / std::sqrt(1 - sine * sine);
            const Vec2 point = r > 0 ? (1 + way / r) * pole : pole;
            const Vec2 pixel = pixel_from_film(film, point);
            const int i = int(pixel.x), j = int(pixel.y);
            // In bars of two halves, the second one shows small differences best.
            const bool upright_half = bar.halves && bar.upright,
                       lying_half = bar.halves && !bar.upright;
            if (i < bar.left + (upright_half ? bar.width / 2 : 0) || i >= bar.left + bar.width ||
                j < bar.top + (lying_half ? bar.height / 2 : 0) || j >= bar.top + bar.height)
                continue;
            const int part = bar.upright ? 8 * (y - bar.top) / bar.height
                                         : 8 * (x - bar.left) / bar.width;
            sums[part] += light(i, j).g;
            ++numbers[part];
        }
    Seen result;
    for (int k = 0; k < 8; ++k)
        result.light += sums[k] / numbers[k] / 8;
    for (int k = 0; k < 8; ++k)
        result.unevenness += std::pow(sums[k] / numbers[k] - result.light, 2) / 8;
    return result;
}

} // namespace

BOOST_AUTO_TEST_SUITE(print_relief_chart)

BOOST_AUTO_TEST_CASE(it_tells_offset_and_pitch)
{
    const struct {
        Arrangement arrangement;
        double slant;
    } sheets[] = {{Arrangement::lenticular, 0},
                  {Arrangement::lenticular, 12},
                  {Arrangement::square, 0},
                  {Arrangement::hexagonal, 0}};
    for (const auto& one : sheets) {
        const ReliefChart chart = chart_of(one.arrangement, one.slant);
        const auto bars = relief_bars(chart);
        const Image picture = relief_chart(chart);
        const auto directions = chart_directions(chart.sheet);
        BOOST_TEST(bars.size() == 23 * directions.size());
        for (std::size_t d = 0; d < directions.size(); ++d)
            for (const double part : {-1.0 / 3, 0.25}) {
                LensSheet printed = chart.sheet;
                const Vec2 off = part * directions[d].period_share * printed.pitch *
                                 directions[d].wave;
                printed.offset = printed.offset + off;
                // The circular mean of the phases, weighted by their light.
                Vec2 mean;
                for (std::size_t k = 23 * d + 11; k < 23 * (d + 1); ++k) {
                    const double turn = 2 * 3.14159265358979 * (double(k - 23 * d) - 16) / 12,
                                 light = seen(chart, picture, bars[k], printed).light;
                    mean = mean + light * Vec2{std::cos(turn), std::sin(turn)};
                }
                const double found = std::atan2(mean.y, mean.x) / (2 * 3.14159265358979);
                BOOST_TEST(std::fabs(found - part) < 0.02, int(one.arrangement)
                                                               << " " << one.slant << ": " << found
                                                               << " instead of " << part);
            }
        for (std::size_t d = 0; d < directions.size(); ++d)
            for (const int bar : {5, 8}) {
                const double requested = bars[23 * d + bar].stretch;
                LensSheet printed = chart.sheet;
                printed.pitch *= 1 + requested;
                std::size_t best = 23 * d;
                double least = 1e9;
                for (std::size_t k = 23 * d; k < 23 * d + 11; ++k) {
                    const double unevenness = seen(chart, picture, bars[k], printed).unevenness;
                    if (unevenness < least) {
                        least = unevenness;
                        best = k;
                    }
                }
                BOOST_TEST(best == 23 * d + bar, int(one.arrangement)
                                                     << " " << one.slant << ": bar "
                                                     << best - 23 * d << " instead of " << bar);
            }
    }
}

BOOST_AUTO_TEST_CASE(lenses_are_over_the_bars_alone)
{
    const ReliefChart chart = chart_of(Arrangement::lenticular, 0);
    const auto bars = relief_bars(chart);
    Image relief = make_image<std::uint16_t>(chart.film.width, chart.film.height, 1, {});
    for (int y = 0; y < relief.height; ++y)
        for (int x = 0; x < relief.width; ++x)
            store_pixel(relief, x, y, {1, 1, 1, 1});
    flatten_beside(bars, 0.25f, relief);
    double inside = 0, all = 0;
    for (const ReliefBar& bar : bars)
        inside += double(bar.width) * bar.height;
    for (int y = 0; y < relief.height; ++y)
        for (int x = 0; x < relief.width; ++x)
            all += stored_pixel(relief, x, y).r > 0.9f;
    BOOST_TEST(all == inside);
    BOOST_TEST(std::fabs(stored_pixel(relief, 0, 0).r - 0.25f) < 1e-4);
}

BOOST_AUTO_TEST_CASE(what_does_not_fit_is_refused)
{
    const auto says = [](const char* words) {
        return [=](const std::invalid_argument& error) {
            return std::string(error.what()).find(words) != std::string::npos;
        };
    };
    ReliefChart chart = chart_of(Arrangement::lenticular, 0);
    chart.film.width = 300;
    BOOST_CHECK_EXCEPTION(relief_bars(chart), std::invalid_argument, says("too narrow"));
    chart = chart_of(Arrangement::lenticular, 0);
    chart.film.height = 600;
    BOOST_CHECK_EXCEPTION(relief_bars(chart), std::invalid_argument, says("too low"));
    chart = chart_of(Arrangement::lenticular, 0);
    chart.sheet.pitch = 0.3;
    BOOST_CHECK_EXCEPTION(relief_bars(chart), std::invalid_argument, says("less than 4 pixels"));
}

BOOST_AUTO_TEST_SUITE_END()
