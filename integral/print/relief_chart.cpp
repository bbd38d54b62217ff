// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/print/relief_chart.h"

#include "integral/base/number_text.h"
#include "integral/io/device_text.h"
#include "integral/optics/lens_sheet.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace integral {
namespace {

constexpr int pitches = 11, phases = 12;                  // bars of a direction
constexpr int places = pitches + 1 + phases;              // with a gap between the two kinds
constexpr double margin = 5, line_height = 3, label = 25; // mm
constexpr double block_gap = 4, bar_share = 0.85, least_place = 2, least_periods = 16;
constexpr double fringes_a_step = 0.5; // along a bar, from one pitch bar to the next
constexpr double least_pixels = 4;     // in a period
constexpr DeviceFont words{2.2, false};

std::vector<std::string> head_of(const ReliefChart& chart, double width)
{
    return wrapped(
        "Print this picture, and the relief over it, both unscaled. Look with one eye from " +
            with_digits(chart.distance, 4) +
            " mm straight in front of the middle. The bar with a percentage that is even says how "
            "much greater than wanted the lenses' pitch is. Of the bars with two numbers, the "
            "middle one of the light ones says the lenses' offset (mm, right and up)" +
            (chart.sheet.arrangement == Arrangement::lenticular
                 ? "."
                 : "; the offsets of both directions are added."),
        width, words);
}

void demand(const char* side, double have, double need)
{
    if (have < need)
        throw std::invalid_argument("the page is too " + std::string(side) + " for a chart: " +
                                    with_decimals(need - have, 1) + " mm more are needed");
}

std::string with_sign(double value, int decimals)
{
    const bool nothing = std::fabs(value) < 0.5 * std::pow(10, -decimals);
    return (value < 0 && !nothing ? "" : "+") + with_decimals(nothing ? 0 : value, decimals);
}

/// A rectangle of the page, mm from its left and top edges.
struct Block {
    double left, top, width, height;
};

/// The k-th pitch bar, from 0 on, `length` mm long; the middle bar's lines are `period` mm apart.
/// Wave and place are not set yet.
ReliefBar pitch_bar(int k, double period, double length, Vec2 pole)
{
    ReliefBar bar;
    bar.halves = true;
    bar.stretch = (k - pitches / 2) * fringes_a_step * period / length;
    bar.period = period * (1 + bar.stretch);
    bar.origin = pole;
    bar.label = with_sign(100 * bar.stretch, 2) + " %";
    return bar;
}

/// The k-th phase bar, from 1 on, for lenses `spacing` mm apart along the wave. Its wave and place
/// are not set yet.
ReliefBar phase_bar(int k, double spacing, double period, Vec2 wave, Vec2 pole)
{
    const double part = double(k - phases / 2) / phases;
    ReliefBar bar;
    bar.halves = false;
    bar.offset = part * spacing * wave;
    bar.period = period;
    bar.origin = pole + part * period * wave;
    bar.label = "<" + with_sign(bar.offset.x, 3) + ", " + with_sign(bar.offset.y, 3) + ">";
    return bar;
}

void add_bars(const ReliefChart& chart, const ChartDirection& direction, const Block& block,
              std::vector<ReliefBar>& bars)
{
    const Film& film = chart.film;
    const LensSheet& sheet = chart.sheet;
    const bool upright = direction.upright;
    const double across = upright ? block.width : block.height,
                 along = (upright ? block.height : block.width) - label;
    const double magnified = 1 + sheet.thickness / (sheet.ior * chart.distance),
                 spacing = direction.period_share * sheet.pitch, period = spacing * magnified;
    const double place = std::max(
        least_place, sheet.arrangement == Arrangement::lenticular ? 0 : 4 * sheet.pitch);
    demand(upright ? "narrow" : "low", across, places * place);
    demand(upright ? "low" : "narrow", along, least_periods * period);
    if (pixel_along(direction.wave, film) * least_pixels > period)
        throw std::invalid_argument("lines " + with_decimals(period, 4) +
                                    " mm apart have less than 4 pixels; a finer printer is needed");
    // In the bars' middle, the lines of a pitch bar agree with the lenses.
    const Lattice lattice(sheet);
    const Vec2 middle{block.left + (upright ? 0 : label) + (upright ? block.width : along) / 2,
                      block.top + (upright ? along : block.height) / 2};
    const Vec2 pole = magnified *
                      lattice.pole(lattice.nearest(film_from_pixel(
                          film, {middle.x / film.pixel_pitch.x, middle.y / film.pixel_pitch.y})));
    for (int k = 0; k < places; ++k) {
        if (k == pitches)
            continue;
        ReliefBar bar = k < pitches ? pitch_bar(k, period, along, pole)
                                    : phase_bar(k - pitches, spacing, period, direction.wave, pole);
        bar.wave = direction.wave;
        bar.upright = upright;
        const double begin = (k + (1 - bar_share) / 2) * across / places,
                     end = begin + bar_share * across / places;
        const Block at = upright ? Block{block.left + begin, block.top, end - begin, along}
                                 : Block{block.left + label, block.top + begin, along, end - begin};
        set_rectangle(film, at.left, at.top, at.left + at.width, at.top + at.height, bar);
        bars.push_back(bar);
    }
}

void write_label(const Film& film, const ReliefBar& bar, Image& image)
{
    const Vec2 pitch = film.pixel_pitch;
    const double left = bar.left * pitch.x, top = bar.top * pitch.y, width = bar.width * pitch.x,
                 height = bar.height * pitch.y, thick = bar.upright ? width : height;
    const DeviceFont font{std::min(2.4, 0.9 * thick), false};
    const double middle = thick / 2 + 0.36 * font.size;
    if (bar.upright) // below the bar, to be read from bottom to top
        write_text(image, pitch, bar.label, {left + middle, top + height + label - 1}, font, true);
    else
        write_text(image, pitch, bar.label, {left - label + 1, top + middle}, font);
}

} // namespace

std::vector<ReliefBar> relief_bars(const ReliefChart& chart)
{
    const double width = chart.film.width * chart.film.pixel_pitch.x,
                 height = chart.film.height * chart.film.pixel_pitch.y, inner = width - 2 * margin;
    demand("narrow", inner, label + least_periods * chart.sheet.pitch);
    const double top = margin + line_height * double(head_of(chart, inner).size() + 1),
                 free = height - top - margin;
    const auto directions = chart_directions(chart.sheet);
    const double number = double(directions.size());
    const bool beside = inner > free;
    std::vector<ReliefBar> bars;
    for (const ChartDirection& direction : directions) {
        const double done = double(&direction - directions.data());
        const double wide = beside ? (inner - block_gap * (number - 1)) / number : inner,
                     high = beside ? free : (free - block_gap * (number - 1)) / number;
        add_bars(chart, direction,
                 {margin + (beside ? done * (wide + block_gap) : 0),
                  top + (beside ? 0 : done * (high + block_gap)), wide, high},
                 bars);
    }
    return bars;
}

Image relief_chart(const ReliefChart& chart)
{
    const std::vector<ReliefBar> bars = relief_bars(chart);
    Image image = make_image<std::uint8_t>(chart.film.width, chart.film.height, 3, {});
    auto& samples = std::get<std::vector<std::uint8_t>>(image.samples);
    std::fill(samples.begin(), samples.end(), std::uint8_t(255));
    for (const ReliefBar& bar : bars) {
        draw_lines(chart.film, bar, image);
        write_label(chart.film, bar, image);
    }
    double baseline = margin;
    for (const std::string& line :
         head_of(chart, chart.film.width * chart.film.pixel_pitch.x - 2 * margin))
        write_text(image, chart.film.pixel_pitch, line, {margin, baseline += line_height}, words);
    return image;
}

void flatten_beside(const std::vector<ReliefBar>& bars, float ground, Image& relief)
{
    std::vector<bool> over(relief.width);
    for (int y = 0; y < relief.height; ++y) {
        std::fill(over.begin(), over.end(), false);
        for (const ReliefBar& bar : bars)
            if (y >= bar.top && y < bar.top + bar.height)
                std::fill_n(over.begin() + bar.left, bar.width, true);
        for (int x = 0; x < relief.width; ++x)
            if (!over[x])
                store_pixel(relief, x, y, {ground, ground, ground, 1});
    }
}

} // namespace integral
