// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests plots: the axes' ranges and labels, the positions of points, and that no point is covered
// or left out without notice.
#include "integral/io/plot.h"

#include "integral/io/image_file.h"
#include "integral/io/plot_axis.h"
#include "integral/io/plot_names.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <filesystem>
#include <limits>
#include <random>

using namespace integral;
namespace fs = std::filesystem;

BOOST_AUTO_TEST_SUITE(io_plot)

namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

/// A temporary folder, removed by the destructor.
struct Folder {
    std::string path;
    Folder()
    {
        char name[] = "/tmp/integral-plot-XXXXXX";
        BOOST_REQUIRE(mkdtemp(name));
        path = name;
    }
    ~Folder() { fs::remove_all(path); }
    std::string operator/(const std::string& name) const { return path + "/" + name; }
    std::size_t files() const
    {
        return std::size_t(std::distance(fs::directory_iterator(path), {}));
    }
};

std::string labels(const PlotScale& scale)
{
    std::string all;
    for (const PlotTick& tick : scale.ticks)
        if (!tick.label.empty())
            all += (all.empty() ? "" : " ") + tick.label +
                   (tick.exponent.empty() ? "" : "^" + tick.exponent);
    return all;
}

PlotAxis axis(bool logarithmic = false, std::optional<double> low = {},
              std::optional<double> high = {})
{
    return {"quantity", logarithmic, low, high};
}

PlotSeries points(std::vector<double> x, std::vector<double> y)
{
    PlotSeries s;
    s.style = PlotSeries::Style::points;
    s.x = x;
    s.y = y;
    return s;
}

Plot plot_of(const PlotSeries& s)
{
    Plot plot;
    plot.title = "Title";
    plot.series = {s};
    return plot;
}

/// The number and the centre of the pixels in blue, the first series' colour.
struct Blue {
    double x = 0, y = 0;
    int count = 0;
};
Blue blue_of(const Plot& plot)
{
    const Folder folder;
    write_plot(plot, folder / "plot.png");
    const Image image = read_frame(folder / "plot.png").image;
    Blue blue;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (const Colour c = stored_pixel(image, x, y); c.b - c.r > 0.3f) {
                blue.x += x;
                blue.y += y;
                ++blue.count;
            }
    if (blue.count > 0) {
        blue.x /= blue.count;
        blue.y /= blue.count;
    }
    return blue;
}

} // namespace

BOOST_AUTO_TEST_CASE(linear_axes_are_rounded_outwards_to_steps_of_1_2_5)
{
    BOOST_TEST(labels(make_scale(axis(), {0.3, 9.7}, 12)) == "0 1 2 3 4 5 6 7 8 9 10");
    BOOST_TEST(labels(make_scale(axis(), {0.3, 9.7}, 6)) == "0 2 4 6 8 10");
    BOOST_TEST(labels(make_scale(axis(), {0, 1}, 6)) == "0 0.2 0.4 0.6 0.8 1.0");
    BOOST_TEST(labels(make_scale(axis(), {-120, 260}, 6)) == "\u2212200 \u2212100 0 100 200 300");
    BOOST_TEST(labels(make_scale(axis(), {0.0101, 0.0149}, 8)) ==
               "0.010 0.011 0.012 0.013 0.014 0.015");
    BOOST_TEST(labels(make_scale(axis(), {0, 3e7}, 5)) == "0 1\u00b710^7 2\u00b710^7 3\u00b710^7");
    // a given end stays where it is
    const PlotScale given = make_scale(axis(false, 0.5, 9.2), {-100, 100}, 6);
    BOOST_TEST(given.low == 0.5);
    BOOST_TEST(given.high == 9.2);
    BOOST_TEST(labels(given) == "2 4 6 8");
}

BOOST_AUTO_TEST_CASE(logarithmic_axes_have_decades)
{
    BOOST_TEST(labels(make_scale(axis(true), {0.3, 70}, 12)) == "0.2 0.5 1 2 5 10 20 50 100");
    BOOST_TEST(labels(make_scale(axis(true), {0.003, 70}, 8)) == "0.01 0.1 1 10 100");
    BOOST_TEST(labels(make_scale(axis(true), {1e-9, 1e9}, 8)) ==
               "10^\u22129 10^\u22126 0.001 1 1000 10^6 10^9");
    BOOST_TEST(labels(make_scale(axis(true), {3, 4}, 12)) == "2 3 4 5");
    // Ticks are the numbers that their labels are, to the last bit.
    for (const PlotTick& tick : make_scale(axis(true), {0.1, 0.9}, 40).ticks)
        if (!tick.label.empty() && tick.exponent.empty())
            BOOST_TEST(tick.value == std::stod(tick.label));
    // Values that a logarithmic axis cannot show do not count.
    BOOST_TEST(labels(make_scale(axis(true), {-5, 0, 1, 10, nan_value}, 8)) == "1 2 5 10");
}

BOOST_AUTO_TEST_CASE(every_axis_holds_its_values)
{
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int round = 0; round < 20000; ++round) {
        const bool logarithmic = round & 1;
        std::vector<double> values;
        for (int i = 0; i < 1 + round % 4; ++i) {
            const double size = std::pow(10,
                                         290 * unit(random) * (round % 3 == 0) + 6 * unit(random));
            values.push_back(logarithmic ? size : size * unit(random));
        }
        const int most = 2 + round % 9;
        const PlotScale scale = make_scale(axis(logarithmic), values, most);
        BOOST_REQUIRE(scale.low < scale.high);
        int labelled = 0;
        for (std::size_t i = 0; i < scale.ticks.size(); ++i) {
            labelled += !scale.ticks[i].label.empty();
            BOOST_REQUIRE(scale.contains(scale.ticks[i].value));
            BOOST_REQUIRE(i == 0 || scale.ticks[i].value > scale.ticks[i - 1].value);
        }
        BOOST_REQUIRE_MESSAGE(labelled >= 1 && labelled <= most + 2,
                              round << ": " << labelled << " of " << most);
        for (const double value : values)
            BOOST_REQUIRE_MESSAGE(scale.contains(value), round << ": " << value << " in "
                                                               << scale.low << " " << scale.high);
    }
}

BOOST_AUTO_TEST_CASE(one_value_or_none_makes_an_axis)
{
    for (const bool logarithmic : {false, true})
        for (const std::vector<double>& values :
             {std::vector<double>{}, {0}, {5}, {-5}, {5, 5}, {nan_value}, {1e300}}) {
            const PlotScale scale = make_scale(axis(logarithmic), values, 6);
            BOOST_TEST(scale.low < scale.high);
            BOOST_TEST(!scale.ticks.empty());
        }
    BOOST_TEST(make_scale(axis(false, 10.0), {3}, 6).high > 10);
    BOOST_TEST(make_scale(axis(false, {}, 10.0), {30}, 6).low < 10);
}

BOOST_AUTO_TEST_CASE(an_impossible_range_is_refused)
{
    for (const PlotAxis& bad :
         {axis(false, 2.0, 1.0), axis(false, 1.0, 1.0), axis(true, 0.0), axis(true, {}, -1.0),
          axis(false, nan_value), axis(false, {}, HUGE_VAL)})
        BOOST_CHECK_THROW(make_scale(bad, {1, 2}, 6), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(points_stand_where_the_axes_say)
{
    for (const bool logarithmic : {false, true}) {
        const auto at = [&](double x, double y) {
            Plot plot = plot_of(points({x}, {y}));
            plot.x = axis(logarithmic, 1.0, 100.0);
            plot.y = axis(logarithmic, 1.0, 10000.0);
            return blue_of(plot);
        };
        const Blue low = at(1, 1), high = at(100, 10000),
                   middle = logarithmic ? at(10, 100) : at(50.5, 5000.5);
        BOOST_TEST(low.count > 30);
        BOOST_TEST(high.x > low.x + 500);
        BOOST_TEST(high.y < low.y - 300);
        BOOST_TEST(std::fabs(middle.x - 0.5 * (low.x + high.x)) < 0.6);
        BOOST_TEST(std::fabs(middle.y - 0.5 * (low.y + high.y)) < 0.6);
        BOOST_TEST(at(101, 10).count == 0); // beyond a given end
        BOOST_TEST(at(10, 0.5).count == 0);
    }
}

BOOST_AUTO_TEST_CASE(values_without_a_place_are_left_out_and_break_the_line)
{
    PlotSeries whole = points({0, 1, 2, 3}, {1, 1, 1, 1});
    whole.style = PlotSeries::Style::line;
    PlotSeries broken = whole;
    broken.y[1] = nan_value;
    PlotSeries endless = whole;
    endless.y[1] = HUGE_VAL;
    Plot plot = plot_of(whole);
    plot.x = axis(false, 0.0, 3.0);
    plot.y = axis(false, 0.0, 2.0);
    const int all = blue_of(plot).count;
    for (const PlotSeries& s : {broken, endless}) {
        plot.series = {s};
        BOOST_TEST(std::fabs(double(blue_of(plot).count) / all - 1.0 / 3) < 0.02);
    }
    plot.y = axis(true, 0.5, 2.0);
    plot.series = {whole};
    plot.series[0].y[1] = 0;
    BOOST_TEST(std::fabs(double(blue_of(plot).count) / all - 1.0 / 3) < 0.02);
}

BOOST_AUTO_TEST_CASE(error_bars_reach_from_low_to_high)
{
    Plot plot = plot_of(points({1}, {5}));
    plot.x = axis(false, 0.0, 2.0);
    plot.y = axis(false, 0.0, 10.0);
    const Blue bare = blue_of(plot);
    plot.series[0].low = {3};
    plot.series[0].high = {9};
    const Blue barred = blue_of(plot);
    BOOST_TEST(barred.count > bare.count + 100);
    BOOST_TEST(barred.y < bare.y - 10); // the bar reaches farther up than down
    plot.y.low.reset();
    plot.y.high.reset();
    plot.series[0].high = {90};
    BOOST_TEST(blue_of(plot).count > bare.count); // the axis holds the bar, too
    // on a logarithmic axis, a bar that ends below 0 has no lower end
    plot.y = axis(true, 1.0, 100.0);
    plot.series[0].low = {-1};
    BOOST_TEST(blue_of(plot).count > bare.count + 100);
}

BOOST_AUTO_TEST_CASE(the_same_plot_is_the_same_bytes)
{
    Plot plot = plot_of(points({1, 2, 3}, {4, 5, 6}));
    plot.title = "a < b & c > \u2212d";
    plot.series[0].names = {"one", "two", "three"};
    plot.series[0].label = "series";
    for (const PlotFormat format : {PlotFormat::svg, PlotFormat::png}) {
        const std::string first = plot_bytes(plot, format);
        BOOST_TEST(first == plot_bytes(plot, format));
        plot.series[0].y[1] = 5.5;
        BOOST_TEST(first != plot_bytes(plot, format));
        plot.series[0].y[1] = 5;
    }
    const std::string svg = plot_bytes(plot, PlotFormat::svg);
    BOOST_TEST(svg.find("<title>a &lt; b &amp; c &gt; \u2212d</title>") != std::string::npos);
    BOOST_TEST(svg.find("width=\"900") != std::string::npos);
    for (const char* word : {"nan", "inf", "<use", "<text", "surface"}) // outlines, finite numbers
        BOOST_TEST(svg.find(word) == std::string::npos, word);
}

BOOST_AUTO_TEST_CASE(contradictions_are_refused)
{
    const Plot good = plot_of(points({1, 2}, {1, 2}));
    const auto refused = [&](auto change) {
        Plot plot = good;
        change(plot);
        BOOST_CHECK_THROW(plot_bytes(plot, PlotFormat::svg), std::invalid_argument);
    };
    BOOST_CHECK_NO_THROW(plot_bytes(good, PlotFormat::svg));
    refused([](Plot& p) { p.series[0].y.pop_back(); });
    refused([](Plot& p) { p.series[0].names = {"one"}; });
    refused([](Plot& p) { p.series[0].low = {0, 0}; });
    refused([](Plot& p) { p.series[0].low = p.series[0].high = {0}; });
    refused([](Plot& p) { p.series[0].band = true; });
    refused([](Plot& p) { p.series[0].colour = -1; });
    refused([](Plot& p) { p.width = 10; });
    refused([](Plot& p) { p.height = 100000; });
    refused([](Plot& p) { p.title = "\xff\xfe"; });
    refused([](Plot& p) { p.series[0].names = {"\xc3", ""}; });
    refused([](Plot& p) { // a legend of 100 rows
        p.series[0].label = std::string(60, 'l');
        p.series.assign(200, PlotSeries(p.series[0]));
    });
    for (const char* file : {"plot.jpg", "plot", ".svg", "-", "plot.SVG.", ""})
        BOOST_CHECK_THROW(plot_format(file), std::invalid_argument);
    BOOST_CHECK(plot_format("a.png") == PlotFormat::png);
    BOOST_CHECK(plot_format("/x.y/a.svg") == PlotFormat::svg);
}

BOOST_AUTO_TEST_CASE(plots_appear_whole_or_not_at_all)
{
    const Folder folder;
    Plot plot = plot_of(points({1}, {1}));
    write_plot(plot, folder / "plot.svg");
    const std::string before = read_file(folder / "plot.svg");
    BOOST_TEST(before == plot_bytes(plot, PlotFormat::svg));
    plot.series[0].y.clear();
    BOOST_CHECK_THROW(write_plot(plot, folder / "plot.svg"), std::invalid_argument);
    BOOST_TEST(read_file(folder / "plot.svg") == before);
    BOOST_TEST(folder.files() == 1u);
    BOOST_CHECK_THROW(write_plot(plot_of(points({1}, {1})), folder / "none/plot.svg"), OutputError);
}

BOOST_AUTO_TEST_CASE(names_keep_off_each_other_and_off_the_marks)
{
    const PlotBox area{0, 0, 600, 400};
    std::mt19937_64 random(5);
    for (int round = 0; round < 20; ++round) {
        std::vector<PlotName> names;
        std::vector<PlotBox> marks;
        for (int i = 0; i < 25; ++i) {
            const double x = 20 + random() % 560, y = 20 + random() % 360;
            names.push_back({x, y, 40, 12, {}, false});
            marks.push_back({x - 4, y - 4, x + 4, y + 4});
        }
        place_names(names, area, marks);
        double covered = 0;
        for (std::size_t i = 0; i < names.size(); ++i) {
            const PlotBox& box = names[i].box;
            BOOST_TEST((box.left >= 0 && box.right <= 600 && box.top >= 0 && box.bottom <= 400));
            for (std::size_t j = 0; j < i; ++j)
                covered += shared_area(box, names[j].box);
            for (const PlotBox& mark : marks)
                covered += shared_area(box, mark);
            const double x = 0.5 * (box.left + box.right), y = 0.5 * (box.top + box.bottom);
            BOOST_TEST(std::hypot(x - names[i].x, y - names[i].y) < 64);
        }
        BOOST_TEST(covered <= 0.005 * 25 * 40 * 12, covered);
    }
}

BOOST_AUTO_TEST_SUITE_END()
