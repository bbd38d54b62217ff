// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/print/pitch_chart.h"

#include "integral/base/constants.h"
#include "integral/base/number_text.h"
#include "integral/io/device_text.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace integral {
namespace {

// Lengths on the page, mm.
constexpr double margin = 5, line_height = 3, block_gap = 4, tick = 1.5, tick_width = 0.2;
constexpr double label = 21, number_width = 6, label_gap = 1;
constexpr double bar_share = 0.88;  // the part of its space that a bar fills; between bars are gaps
constexpr double least_bar = 1.8;   // a bar's width in mm at which its labels can just be read
constexpr double least_periods = 8; // in a bar's length
constexpr double least_pixels = 2;  // in a period
// The shortest viewing distance, in lengths of a bar. From nearer, the t/n that the lenses at a
// bar's ends give would be wrong by more than 1%.
constexpr double least_distance = 2;
constexpr DeviceFont words{2.2, false}, title{2.6, true};

/// The bars of one direction. They fill a rectangle, in mm from the page's left and top edges.
struct Block : ChartDirection {
    double left = 0, top = 0, width = 0, height = 0;
};

struct Layout {
    std::vector<std::string> title, head, foot;
    std::vector<Block> blocks;
};

std::vector<Block> directions_of(const LensSheet& sheet)
{
    std::vector<Block> blocks;
    for (const ChartDirection& direction : chart_directions(sheet))
        blocks.push_back({direction});
    return blocks;
}

std::string name_of_sheet(const LensSheet& sheet)
{
    const char* kind = sheet.arrangement == Arrangement::lenticular ? "lenticular"
                       : sheet.arrangement == Arrangement::square   ? "square lenses"
                                                                    : "hexagonal lenses";
    return std::string(kind) + ", nominal pitch " + with_digits(sheet.pitch, 6) + " mm (" +
           with_decimals(mm_per_inch / sheet.pitch, 3) + " lpi), thickness " +
           with_digits(sheet.thickness, 6) + " mm, index " + with_digits(sheet.ior, 6) +
           (sheet.slant != 0 ? ", slant " + with_digits(sheet.slant, 6) + " degrees" : "");
}

/// Number of the middle bar, which has the calibrated pitch on a panel's card.
int middle_bar(const PitchChart& chart) { return (chart.scale.bars + 1) / 2; }

std::string title_of(const PitchChart& chart)
{
    if (!chart.panel.empty())
        return "Pitch card: " + chart.panel;
    const auto dpi = [](double pitch) { return with_decimals(mm_per_inch / pitch, 0); };
    return "Pitch chart: " + name_of_sheet(chart.sheet) + ". " + dpi(chart.film.pixel_pitch.x) +
           " x " + dpi(chart.film.pixel_pitch.y) + " dpi";
}

/// Text with the bar that looks even from each viewing distance of at least `nearest` mm, and with
/// the difference between that bar's pitch and the lenses' own pitch.
std::string bias_line(const PitchChart& chart, double nearest)
{
    std::string even, less;
    for (const double distance : chart.distances) {
        if (distance < nearest)
            continue;
        const double bias = chart.sheet.thickness / (chart.sheet.ior * distance);
        const double pitch = chart.sheet.pitch * (1 + bias), bar = bar_of_pitch(chart.scale, pitch);
        const bool there = bar > 0.5 && bar < chart.scale.bars + 0.5;
        even += (even.empty() ? "" : ", ") + ("from " + with_digits(distance, 6) + " mm ") +
                (there ? "bar " + with_decimals(bar, 1) : std::string("none")) + " (" +
                with_decimals(pitch, 4) + ")";
        less += (less.empty() ? "" : ", ") + with_decimals(100 * (1 - 1 / (1 + bias)), 2) +
                "% from " + with_digits(distance, 6) + " mm";
    }
    const double own = bar_of_pitch(chart.scale, chart.sheet.pitch);
    const std::string end = "its own pitch is bar " + with_decimals(own, 1) + "'s.";
    if (even.empty())
        return "Of the nominal sheet: " + end;
    return "The lenses' own pitch is less than the even bar's, by " + less +
           ". Even under the nominal sheet: " + even + "; " + end;
}

/// Throws std::invalid_argument if the page or panel has less room (mm) than `what` needs.
void demand_room(const PitchChart& chart, double have, double need, const char* side,
                 const std::string& what)
{
    if (have >= need)
        return;
    const bool paper = chart.panel.empty();
    const std::string bars = what.find("bars") != std::string::npos ? " or fewer bars" : "";
    throw std::invalid_argument("the " + std::string(paper ? "page" : "panel") + " is too " + side +
                                " for " + what + ": " + with_decimals(need - have, 1) +
                                " mm more are needed; " +
                                (paper ? "take a larger page" + bars
                                       : "the card of views has room: from the viewing distance "
                                         "one number fills the panel where the pitch is right"));
}

Layout layout_of(const PitchChart& chart)
{
    const double width = chart.film.width * chart.film.pixel_pitch.x,
                 height = chart.film.height * chart.film.pixel_pitch.y, inner = width - 2 * margin;
    demand_room(chart, width, 2 * margin + 2 * label + 10, "narrow", "a chart");
    Layout layout;
    layout.blocks = directions_of(chart.sheet);
    layout.title = wrapped(title_of(chart), inner, title);
    layout.head = wrapped(chart_advice(chart), inner, words);
    const double count = double(layout.blocks.size());
    const bool beside = width > height;
    const double longest = (beside ? (inner - block_gap * (count - 1)) / count : inner) - 2 * label;
    layout.foot = wrapped(chart.panel.empty()
                              ? bias_line(chart, least_distance * longest)
                              : "Is another bar even, its mm are micro_image_pitch_mm of the "
                                "panel's description, and its lpi the pitch of a calibration.",
                          inner, words);
    for (const std::string& line : wrapped(chart.note, inner, words))
        layout.foot.push_back(line);

    const double top = margin + line_height * double(layout.title.size() + layout.head.size()) +
                       tick + 1;
    const double free = height - margin - line_height * double(layout.foot.size()) - tick - 1 - top;
    for (std::size_t k = 0; k < layout.blocks.size(); ++k) {
        Block& block = layout.blocks[k];
        block.width = beside ? (inner - block_gap * (count - 1)) / count : inner;
        block.height = beside ? free : (free - block_gap * (count - 1)) / count;
        block.left = margin + (beside ? double(k) * (block.width + block_gap) : 0);
        block.top = top + (beside ? 0 : double(k) * (block.height + block_gap));
    }
    return layout;
}

/// Adds the bars of one block, numbered from `number` on.
void add_bars(const PitchChart& chart, const Block& block, int number, std::vector<ChartBar>& bars)
{
    const Film& film = chart.film;
    const int count = chart.scale.bars;
    const double across = block.upright ? block.width : block.height,
                 along = (block.upright ? block.height : block.width) - 2 * label;
    const double two_dimensional = chart.sheet.arrangement == Arrangement::lenticular
                                       ? 0
                                       : 2 * chart.sheet.pitch;
    demand_room(chart, across, count * std::max(least_bar, two_dimensional) / bar_share,
                block.upright ? "narrow" : "low", std::to_string(count) + " bars");
    demand_room(chart, along, least_periods * film_pitch(chart.scale, count),
                block.upright ? "low" : "narrow", "lines of this pitch");
    const double space = across / count;
    const Vec2 middle{block.left + block.width / 2, block.top + block.height / 2};
    const Vec2 origin = film_from_pixel(
        film, {middle.x / film.pixel_pitch.x, middle.y / film.pixel_pitch.y});
    for (int k = 0; k < count; ++k) {
        ChartBar bar;
        bar.number = number + k;
        bar.pitch = film_pitch(chart.scale, bar.number);
        bar.period = block.period_share * bar.pitch;
        bar.wave = block.wave;
        bar.origin = origin;
        bar.upright = block.upright;
        const double begin = (k + (1 - bar_share) / 2) * space, end = begin + bar_share * space;
        const double left = block.left + (block.upright ? begin : label),
                     right = block.upright ? block.left + end : left + along;
        const double top = block.top + (block.upright ? label : begin),
                     bottom = block.upright ? top + along : block.top + end;
        set_rectangle(film, left, top, right, bottom, bar);
        if (pixel_along(bar.wave, film) * least_pixels > bar.period)
            throw std::invalid_argument(
                "lines " + with_decimals(bar.period, 4) +
                " mm apart are less than 2 pixels a line pair; a finer device is needed");
        bars.push_back(bar);
    }
}

std::vector<ChartBar> bars_of(const PitchChart& chart, const Layout& layout)
{
    std::vector<ChartBar> bars;
    for (const Block& block : layout.blocks)
        add_bars(chart, block, 1 + int(bars.size()), bars);
    return bars;
}

/// Writes a label at each end of a bar: its number, and its pitch in mm and lpi.
void write_labels(const Film& film, const ChartBar& bar, Image& image)
{
    const double left = bar.left * film.pixel_pitch.x, top = bar.top * film.pixel_pitch.y;
    const double width = bar.width * film.pixel_pitch.x, height = bar.height * film.pixel_pitch.y;
    const double thick = bar.upright ? width : height, length = bar.upright ? height : width;
    const std::string pitch = with_decimals(bar.pitch, 4) + " mm",
                      lenses = with_decimals(mm_per_inch / bar.pitch, 3) + " lpi";
    // Both figures in one line, or each in its own, whichever allows larger letters.
    const std::string both = pitch + "  " + lenses;
    const double in_one = std::min(0.8 * thick, (label - number_width - 2 * label_gap) /
                                                    text_width(both, {1, false})),
                 in_two = 0.46 * thick;
    const std::string name = std::to_string(bar.number);
    const DeviceFont number{
        std::min({3.2, 0.8 * thick, (number_width - 0.5) / text_width(name, {1, true})}), true};
    const DeviceFont figures{std::min(2.0, std::max(in_one, in_two)), false};
    for (const double begin : {-label, length + label_gap}) {
        // `along` is measured from the bar's left end, or its lower end if it is upright; `across`
        // from its upper or left side.
        const auto put = [&](const std::string& text, double along, double across,
                             DeviceFont font) {
            const Vec2 at = bar.upright ? Vec2{left + across, top + height - along}
                                        : Vec2{left + along, top + across};
            write_text(image, film.pixel_pitch, text, at, font, bar.upright);
        };
        put(name, begin, thick / 2 + 0.36 * number.size, number);
        if (in_one > in_two) {
            put(both, begin + number_width, thick / 2 + 0.36 * figures.size, figures);
        } else {
            put(pitch, begin + number_width, thick / 2 - 0.12 * figures.size, figures);
            put(lenses, begin + number_width, thick / 2 + 0.94 * figures.size, figures);
        }
    }
}

/// Draws a black rectangle, given in mm from the left and top edges.
void fill(Image& image, Vec2 pitch, double left, double top, double width, double height)
{
    const auto at = [](double mm, double pixel, int most) {
        return std::clamp(int(std::lround(mm / pixel)), 0, most);
    };
    for (int y = at(top, pitch.y, image.height); y < at(top + height, pitch.y, image.height); ++y)
        for (int x = at(left, pitch.x, image.width); x < at(left + width, pitch.x, image.width);
             ++x)
            store_pixel(image, x, y, {0, 0, 0, 1});
}

/// Draws a tick at either end of the line on which all bars of a block have the same phase.
void draw_ticks(Image& image, Vec2 pitch, const Block& block)
{
    const double x = block.left + block.width / 2 - tick_width / 2,
                 y = block.top + block.height / 2 - tick_width / 2;
    if (block.upright) {
        fill(image, pitch, block.left - tick, y, tick, tick_width);
        fill(image, pitch, block.left + block.width, y, tick, tick_width);
    } else {
        fill(image, pitch, x, block.top - tick, tick_width, tick);
        fill(image, pitch, x, block.top + block.height, tick_width, tick);
    }
}

void check(const PitchChart& chart)
{
    const PitchScale& scale = chart.scale;
    if (!(scale.first > 0 && scale.step > 0 && scale.bars >= 1 && std::isfinite(scale.first) &&
          std::isfinite(scale.step)))
        throw std::invalid_argument(
            "a chart's first pitch and step must be greater than 0, and it must have a bar");
}

} // namespace

std::string chart_advice(const PitchChart& chart)
{
    const std::vector<Block> blocks = directions_of(chart.sheet);
    const std::string middle = "bar " + std::to_string(middle_bar(chart)),
                      second = std::to_string(chart.scale.bars + middle_bar(chart));
    std::string text =
        chart.panel.empty()
            ? "Print unscaled. Lay the lenses on the bars, the numbers left free, and look with "
              "one eye from straight in front of the middle, "
              "from a measured distance, twice a bar's length or more. The even bar counts, or the "
              "two alike that are most even."
            : "Shown pixel for pixel. Look with one eye from straight in front of the middle, " +
                  with_digits(chart.distances.at(0), 3) + " mm away: " + middle +
                  (blocks.size() > 1 ? ", and of the other direction " + second + "," : "") +
                  " is to be even, or the most even; it has the calibrated pitch.";
    bool lying = false, upright = false;
    for (const Block& block : blocks)
        (block.upright ? upright : lying) = true;
    if (lying)
        text += " Bands of the lower halves to the right of the upper halves': this bar's pitch is "
                "too small.";
    if (upright)
        text += " Bands of the right halves above the left halves': this bar's pitch is too small.";
    return text;
}

std::vector<ChartBar> chart_bars(const PitchChart& chart)
{
    check(chart);
    return bars_of(chart, layout_of(chart));
}

Image pitch_chart(const PitchChart& chart)
{
    check(chart);
    const Layout layout = layout_of(chart);
    const std::vector<ChartBar> bars = bars_of(chart, layout);
    const Vec2 pitch = chart.film.pixel_pitch;
    Image image = make_image<std::uint8_t>(chart.film.width, chart.film.height, 3, {});
    auto& samples = std::get<std::vector<std::uint8_t>>(image.samples);
    std::fill(samples.begin(), samples.end(), std::uint8_t(255));
    for (const ChartBar& bar : bars) {
        draw_lines(chart.film, bar, image);
        write_labels(chart.film, bar, image);
    }
    for (const Block& block : layout.blocks)
        draw_ticks(image, pitch, block);

    double baseline = margin;
    const auto write = [&](const std::vector<std::string>& lines, DeviceFont font) {
        for (const std::string& line : lines)
            write_text(image, pitch, line, {margin, baseline += line_height}, font);
    };
    write(layout.title, title);
    write(layout.head, words);
    baseline = chart.film.height * pitch.y - margin - line_height * double(layout.foot.size()) -
               0.5;
    write(layout.foot, words);
    return image;
}

} // namespace integral
