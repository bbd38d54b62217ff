// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests pitch charts: measures Fourier components of the drawn pictures, and reads replayed charts
// as an eye would.
#include "integral/io/device_text.h"
#include "integral/print/pitch_chart.h"
#include "tests/unit/replay_frames.h"

#include <boost/test/unit_test.hpp>

#include <complex>
#include <random>
#include <stdexcept>
#include <utility>

using namespace integral;

BOOST_AUTO_TEST_SUITE(print_pitch_chart)

namespace {

PitchChart chart_of(Arrangement arrangement, double pitch, double slant, Vec2 dpi, Vec2 page,
                    PitchScale scale)
{
    PitchChart chart;
    chart.sheet.arrangement = arrangement;
    chart.sheet.pitch = pitch;
    chart.sheet.slant = slant;
    chart.film.pixel_pitch = {25.4 / dpi.x, 25.4 / dpi.y};
    chart.film.width = int(std::lround(page.x / chart.film.pixel_pitch.x));
    chart.film.height = int(std::lround(page.y / chart.film.pixel_pitch.y));
    chart.scale = scale;
    chart.note = "a note";
    return chart;
}

std::vector<PitchChart> some_charts()
{
    const PitchScale about_1_27{1.252, 0.002, 25};
    return {
        chart_of(Arrangement::lenticular, 1.27, 0, {300, 300}, {152.4, 101.6}, about_1_27),
        chart_of(Arrangement::lenticular, 1.27, 9.46, {300, 300}, {152.4, 101.6}, about_1_27),
        chart_of(Arrangement::lenticular, 1.27, -60, {300, 600}, {203.2, 152.4}, about_1_27),
        chart_of(Arrangement::lenticular, 0.25, 0, {600, 300}, {152.4, 101.6}, {0.248, 0.0001, 20}),
        chart_of(Arrangement::square, 1.27, 0, {300, 300}, {210, 297}, {1.262, 0.002, 15}),
        chart_of(Arrangement::square, 1, 15, {300, 300}, {297, 210}, {0.99, 0.003, 12}),
        chart_of(Arrangement::hexagonal, 1.27, 0, {300, 400}, {297, 210}, {1.262, 0.002, 15})};
}

/// Position of a pixel's centre on the film, mm, y upwards; does not use the library's formula.
Vec2 place_of(const Film& film, int x, int y)
{
    return {(2 * x + 1 - film.width) * film.pixel_pitch.x / 2,
            (film.height - 2 * y - 1) * film.pixel_pitch.y / 2};
}

struct Component {
    double phase;  ///< periods by which the lines are farther along the wave than they should be
    double middle; ///< the middle of the part that was measured, pixels along the bar
};

/// The Fourier component of a bar's half at its stated period, in linear light, over [from, to] of
/// its length and over its whole thickness.
Component component(const PitchChart& chart, const ChartBar& bar, const Image& image, bool second,
                    double from, double to)
{
    const int length = bar.upright ? bar.height : bar.width,
              thickness = bar.upright ? bar.width : bar.height;
    const int begin = int(from * length), end = int(to * length);
    const int first = second ? thickness / 2 : 0, last = second ? thickness : thickness / 2;
    std::complex<double> sum = 0;
    for (int along = begin; along < end; ++along) {
        // With the Blackman-Harris window, other frequencies contribute less than 1e-4.
        const double u = 2 * pi * (along - begin + 0.5) / (end - begin);
        const double window = 0.35875 - 0.48829 * std::cos(u) + 0.14128 * std::cos(2 * u) -
                              0.01168 * std::cos(3 * u);
        for (int across = first; across < last; ++across) {
            const int x = bar.left + (bar.upright ? across : along),
                      y = bar.top + (bar.upright ? along : across);
            const Vec2 at = place_of(chart.film, x, y);
            const double turns = (bar.wave.x * (at.x - bar.origin.x) +
                                  bar.wave.y * (at.y - bar.origin.y)) /
                                 bar.period;
            sum += window * decode({}, stored_pixel(image, x, y).g) *
                   std::polar(1.0, 2 * pi * turns);
        }
    }
    double phase = std::arg(sum) / (2 * pi) - (second ? 0.25 : 0);
    phase -= std::round(phase);
    return {phase, 0.5 * (begin + end)};
}

} // namespace

BOOST_AUTO_TEST_CASE(a_pixel_holds_how_much_of_it_the_lines_cover,
                     *boost::unit_test::label("many_pixels"))
{
    std::mt19937 random(6);
    std::uniform_real_distribution<double> phases(-3, 3), widths(0.001, 0.24);
    for (int k = 0; k < 60; ++k) {
        const double phase = phases(random), a = widths(random),
                     b = k % 3 == 0 ? 0 : widths(random);
        constexpr int n = 1500;
        const double share = k % 2 ? 0.5 : 0.05 + 0.9 * k / 60;
        int light = 0;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < (b > 0 ? n : 1); ++j) {
                const double u = phase + a * ((2 * i + 1.0) / n - 1) +
                                 (b > 0 ? b * ((2 * j + 1.0) / n - 1) : 0);
                light += std::fabs(u - std::round(u)) < 0.5 * share;
            }
        const double counted = double(light) / n / (b > 0 ? n : 1);
        BOOST_TEST(std::fabs(line_coverage(phase, a, b, share) - counted) < 1e-3,
                   "at " << phase << ", " << a << ", " << b << ", " << share);
        BOOST_TEST(std::fabs(line_coverage(phase, b, a) - line_coverage(phase, a, b)) < 1e-12);
    }
}

BOOST_AUTO_TEST_CASE(every_bar_has_its_stated_pitch_and_phase,
                     *boost::unit_test::label("many_pixels"))
{
    double worst_pitch = 0, worst_phase = 0;
    for (const PitchChart& chart : some_charts()) {
        const Image image = pitch_chart(chart);
        double worst_here = 0;
        for (const ChartBar& bar : chart_bars(chart))
            for (const bool second : {false, true}) {
                const Component low = component(chart, bar, image, second, 0, 0.6),
                                high = component(chart, bar, image, second, 0.4, 1);
                const double pixel = bar.upright ? chart.film.pixel_pitch.y
                                                 : chart.film.pixel_pitch.x;
                const double rate = std::fabs(bar.upright ? bar.wave.y : bar.wave.x) /
                                    bar.period; // lines a mm along the bar
                const double error = (high.phase - low.phase) /
                                     ((high.middle - low.middle) * pixel * rate);
                const double phase = (high.phase + low.phase) / 2;
                BOOST_TEST(std::fabs(error) < 1e-5, "bar " << bar.number << " of "
                                                           << chart.film.width
                                                           << " pixels is wrong by " << error);
                BOOST_TEST(std::fabs(phase) < 1e-3, "bar " << bar.number << " is off by " << phase);
                worst_here = std::max(worst_here, std::fabs(error));
                worst_phase = std::max(worst_phase, std::fabs(phase));
            }
        BOOST_TEST_MESSAGE("pitch " << chart.sheet.pitch << " slant " << chart.sheet.slant << ": "
                                    << worst_here);
        worst_pitch = std::max(worst_pitch, worst_here);
    }
    BOOST_TEST_MESSAGE("greatest error of a pitch " << worst_pitch << ", of a phase " << worst_phase
                                                    << " periods");
}

BOOST_AUTO_TEST_CASE(bars_are_in_phase_in_their_middle_and_nothing_leaves_the_page)
{
    for (const PitchChart& chart : some_charts()) {
        const auto bars = chart_bars(chart);
        BOOST_TEST(bars.size() == std::size_t(chart.scale.bars) *
                                      (chart.sheet.arrangement == Arrangement::lenticular ? 1 : 2));
        std::vector<int> owner(std::size_t(chart.film.width) * chart.film.height, 0);
        for (std::size_t k = 0; k < bars.size(); ++k) {
            const ChartBar& bar = bars[k];
            BOOST_TEST(bar.number == int(k) + 1);
            BOOST_TEST(
                std::fabs(bar.pitch - (chart.scale.first + double(int(k) % chart.scale.bars) *
                                                               chart.scale.step)) < 1e-12);
            const Vec2 middle = place_of(chart.film, bar.left, bar.top); // of the first pixel
            const double x = middle.x + 0.5 * (bar.width - 1) * chart.film.pixel_pitch.x,
                         y = middle.y - 0.5 * (bar.height - 1) * chart.film.pixel_pitch.y;
            BOOST_TEST(std::fabs(bar.upright ? y - bar.origin.y : x - bar.origin.x) <= 0.1);
            BOOST_TEST(std::fabs(std::hypot(bar.wave.x, bar.wave.y) - 1) < 1e-12);
            BOOST_REQUIRE((bar.left >= 0 && bar.top >= 0 &&
                           bar.left + bar.width <= chart.film.width &&
                           bar.top + bar.height <= chart.film.height));
            bool shared = false;
            for (int row = bar.top; row < bar.top + bar.height; ++row)
                for (int column = bar.left; column < bar.left + bar.width; ++column)
                    shared = shared ||
                             std::exchange(owner[std::size_t(row) * chart.film.width + column],
                                           1) == 1;
            BOOST_TEST(!shared);
        }
    }
}

BOOST_AUTO_TEST_CASE(lines_of_a_second_direction_are_those_of_the_lattice)
{
    // Every lens of a lattice scaled to the bar's pitch is at the same phase of its lines.
    for (const PitchChart& chart : some_charts())
        for (const ChartBar& bar : chart_bars(chart)) {
            LensSheet sheet = chart.sheet;
            sheet.pitch = bar.pitch;
            const Lattice lattice(sheet);
            for (std::int64_t i = -3; i <= 3; ++i)
                for (std::int64_t j = -3; j <= 3; ++j) {
                    const Vec2 pole = lattice.pole(
                        {i, chart.sheet.arrangement == Arrangement::lenticular ? 0 : j});
                    const double turns = dot(bar.wave, pole) / bar.period;
                    BOOST_TEST(std::fabs(turns - std::round(turns)) < 1e-9);
                }
        }
}

namespace {

/// The black in a part of a picture, pixels.
double ink(const Image& image, int left, int top, int width, int height)
{
    double sum = 0;
    for (int y = top; y < top + height; ++y)
        for (int x = left; x < left + width; ++x)
            sum += 1 - decode({}, stored_pixel(image, x, y).g);
    return sum;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_bar_s_number_is_printed_in_bold)
{
    const PitchChart chart = chart_of(Arrangement::lenticular, 1.27, 0, {600, 600}, {152.4, 101.6},
                                      {1.252, 0.004, 9});
    const Image page = pitch_chart(chart);
    constexpr double column = 21, column_width = 6; // mm from the bar, before its figures
    for (const ChartBar& bar : chart_bars(chart)) {
        const double pixel = chart.film.pixel_pitch.x;
        const double printed = ink(page, bar.left - int(column / pixel), bar.top,
                                   int(column_width / pixel), bar.height);
        const auto written = [&](bool bold) {
            Image empty = make_image<std::uint8_t>(400, 400, 3, {});
            auto& samples = std::get<std::vector<std::uint8_t>>(empty.samples);
            std::fill(samples.begin(), samples.end(), std::uint8_t(255));
            write_text(empty, chart.film.pixel_pitch, std::to_string(bar.number), {5, 8},
                       {3.2, bold});
            return ink(empty, 0, 0, 400, 400);
        };
        BOOST_TEST(written(false) < 0.9 * written(true));
        BOOST_TEST(printed == written(true), boost::test_tools::tolerance(0.03));
    }
}

BOOST_AUTO_TEST_CASE(a_panel_s_card_does_not_say_that_it_is_printed)
{
    PitchChart chart = chart_of(Arrangement::lenticular, 1.27, -9, {300, 300}, {152, 102},
                                {1.252, 0.002, 11});
    const auto says = [&](const char* words) {
        return chart_advice(chart).find(words) != std::string::npos;
    };
    BOOST_TEST((says("Print unscaled") && says("Lay the lenses on the bars")));
    chart.panel = "mine";
    chart.distances = {380};
    BOOST_TEST(
        (!says("Print") && !says("Lay the lenses") && says("380 mm away: bar 6 is to be even")));
}

BOOST_AUTO_TEST_CASE(charts_that_have_no_room_are_refused)
{
    const PitchScale scale{1.252, 0.002, 25};
    const auto refused = [](const PitchChart& chart, const std::string& words) {
        try {
            pitch_chart(chart);
            BOOST_ERROR("not refused: " << words);
        } catch (const std::invalid_argument& error) {
            BOOST_TEST((std::string(error.what()).find(words) != std::string::npos), error.what());
        }
    };
    refused(chart_of(Arrangement::lenticular, 1.27, 0, {300, 300}, {50, 100}, scale),
            "too narrow for a chart");
    refused(chart_of(Arrangement::lenticular, 1.27, 0, {300, 300}, {150, 60}, scale),
            "too low for 25 bars");
    refused(chart_of(Arrangement::hexagonal, 1.27, 0, {300, 300}, {152, 102}, scale), "25 bars");
    refused(chart_of(Arrangement::lenticular, 12.7, 0, {300, 300}, {150, 100}, {12.5, 0.02, 20}),
            "too narrow for lines");
    refused(chart_of(Arrangement::lenticular, 0.1, 0, {300, 300}, {150, 100}, {0.1, 0.001, 10}),
            "less than 2 pixels");
    refused(chart_of(Arrangement::lenticular, 1.27, 0, {300, 300}, {150, 100}, {1.27, 0, 10}),
            "greater than 0");
    refused(chart_of(Arrangement::lenticular, 1.27, 0, {300, 300}, {150, 100}, {1.27, 0.1, 0}),
            "greater than 0");
    // A panel cannot be made larger.
    for (const Vec2 size : {Vec2{50, 100}, Vec2{150, 60}}) {
        PitchChart chart = chart_of(Arrangement::lenticular, 1.27, 0, {300, 300}, size, scale);
        chart.panel = "mine";
        refused(chart, "the panel is too ");
        refused(chart, " mm more are needed; the card of views has room");
    }
}

namespace {

/// The unevenness of each bar of a replayed page: the variance of light along its halves, smoothed
/// over three lenses.
std::vector<double> unevenness(const PitchChart& chart, const std::vector<ChartBar>& bars,
                               const Image& view)
{
    std::vector<double> result;
    for (const ChartBar& bar : bars) {
        const int whole = bar.upright ? bar.height : bar.width,
                  thickness = bar.upright ? bar.width : bar.height;
        const int lens = int(std::lround(
            3 * bar.pitch / (bar.upright ? chart.film.pixel_pitch.y : chart.film.pixel_pitch.x)));
        const int begin = lens,
                  length = whole - 2 * lens; // outer lenses show what is beyond the bar's ends
        double sum = 0;
        for (const bool second : {false, true}) {
            std::vector<double> total(1, 0.0); // of the light from the beginning
            for (int along = 0; along < length; ++along) {
                double light = 0;
                // The halves' inner parts: a lens is as high as a few pixels.
                for (int part = 0; part < 16; ++part) {
                    const int across = int(thickness *
                                           ((second ? 0.5 : 0) + 0.1 + 0.3 * (part + 0.5) / 16));
                    light += decode({}, stored_pixel(
                                            view, bar.left + (bar.upright ? across : begin + along),
                                            bar.top + (bar.upright ? begin + along : across))
                                            .g) /
                             16;
                }
                total.push_back(total.back() + light);
            }
            double mean = 0, square = 0;
            const int count = length - lens;
            for (int k = 0; k < count; ++k) {
                const double smooth = (total[k + lens] - total[k]) / lens;
                mean += smooth / count;
                square += smooth * smooth / count;
            }
            sum += square - mean * mean;
        }
        result.push_back(sum);
    }
    return result;
}

/// The bar of one direction that looks most even to an eye on the axis, while the sheet is moved by
/// one lens pitch in `steps` steps. Their number is odd, so that a bar's second half, which is
/// shifted by a quarter of a period, shows other phases than its first.
int most_even(const PitchChart& chart, const LensSheet& truth, double distance, int direction,
              int steps)
{
    Frame frame{pitch_chart(chart), {}};
    std::vector<ChartBar> bars = chart_bars(chart);
    bars = {bars.begin() + direction * chart.scale.bars,
            bars.begin() + (direction + 1) * chart.scale.bars};
    std::vector<double> sums(bars.size());
    for (int k = 0; k < steps; ++k) {
        FrameMetadata metadata;
        metadata.sheet = truth;
        metadata.sheet.offset = ((k + 0.37) / steps * bars[0].period) * bars[0].wave;
        metadata.film = chart.film;
        metadata.aperture.distance = distance;
        metadata.aperture.width = metadata.aperture.height = 200;
        set_metadata(frame, metadata);
        const auto seen = unevenness(
            chart, bars,
            *replay(frame, {{0, 0, distance}, chart.film.width, chart.film.height, 1}));
        for (std::size_t bar = 0; bar < sums.size(); ++bar)
            sums[bar] += seen[bar];
    }
    return bars[std::size_t(std::min_element(sums.begin(), sums.end()) - sums.begin())].number;
}

} // namespace

BOOST_AUTO_TEST_CASE(an_eye_at_a_replayed_chart_reads_the_true_pitch,
                     *boost::unit_test::label("many_pixels"))
{
    struct {
        PitchChart chart;
        double pitch, ior, distance;
        int direction;
    } const trials[] = {
        {chart_of(Arrangement::lenticular, 1.27, 0, {300, 300}, {152.4, 101.6}, {1.252, 0.002, 25}),
         1.2741, 1.6, 400, 0},
        {chart_of(Arrangement::lenticular, 1.27, 0, {300, 300}, {152.4, 101.6}, {1.252, 0.002, 25}),
         1.2672, 1.55, 300, 0},
        {chart_of(Arrangement::lenticular, 1.27, 9.46, {300, 300}, {152.4, 101.6},
                  {1.252, 0.002, 25}),
         1.2741, 1.6, 400, 0},
        {chart_of(Arrangement::square, 1.27, 0, {300, 300}, {203.2, 152.4}, {1.256, 0.004, 10}),
         1.2741, 1.6, 400, 1},
        {chart_of(Arrangement::hexagonal, 1.27, 0, {300, 300}, {203.2, 152.4}, {1.256, 0.004, 10}),
         1.2741, 1.6, 400, 0},
    };
    for (const auto& trial : trials) {
        LensSheet truth = trial.chart.sheet;
        truth.pitch = trial.pitch;
        truth.ior = trial.ior;
        const int bar = most_even(trial.chart, truth, trial.distance, trial.direction, 3);
        LensSheet nominal = trial.chart.sheet;
        nominal.ior = trial.ior;
        const MeasuredSheet found = measured_sheet(nominal, trial.chart.scale,
                                                   {{{bar}, trial.distance}});
        const double naive = film_pitch(trial.chart.scale, bar), step = trial.chart.scale.step;
        const double bias = truth.pitch * truth.thickness / (truth.ior * trial.distance);
        BOOST_TEST_MESSAGE("bar " << bar << ": " << found.pitch.value << " for " << truth.pitch
                                  << ", naively " << naive);
        BOOST_TEST(std::fabs(found.pitch.value - truth.pitch) <= step / 2);
        BOOST_TEST(std::fabs(naive - truth.pitch - bias) <= step / 2 * 1.01);
    }
}

BOOST_AUTO_TEST_CASE(an_eye_at_two_distances_reads_the_index_too,
                     *boost::unit_test::label("many_pixels"))
{
    const PitchChart chart = chart_of(Arrangement::lenticular, 1.27, 0, {600, 300}, {152.4, 100},
                                      {1.27, 0.001, 21});
    LensSheet truth = chart.sheet;
    truth.pitch = 1.2742;
    truth.ior = 1.53;
    std::vector<ChartReading> readings;
    for (const double distance : {200.0, 1500.0}) // twice a bar's length and more
        readings.push_back({{most_even(chart, truth, distance, 0, 9)}, distance});
    const MeasuredSheet found = measured_sheet(chart.sheet, chart.scale, readings);
    BOOST_TEST_MESSAGE("pitch " << found.pitch.value << " +- " << found.pitch.error << ", index "
                                << found.index.value << " +- " << found.index.error);
    BOOST_TEST(std::fabs(found.pitch.value - truth.pitch) <= found.pitch.error);
    BOOST_TEST((truth.ior >= found.least_index && truth.ior <= found.greatest_index));
    BOOST_TEST(found.index.error < 0.2);
}

BOOST_AUTO_TEST_SUITE_END()
