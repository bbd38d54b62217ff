// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/panel/lens_cards.h"

#include "integral/base/constants.h"
#include "integral/base/number_text.h"
#include "integral/base/parallel.h"
#include "integral/frame/linear_writer.h"
#include "integral/io/device_text.h"
#include "integral/optics/visual_pitch.h"
#include "integral/print/chart_lines.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace integral {
namespace {

// Lengths in pitches of the lenses. Behind each lens, the eye sees one column of the film: numbers
// need to be many lenses wide to be legible.
constexpr double margin = 2;
constexpr double least_font = 8.5, largest_font = 16;
constexpr double number_width = 1.6;   // of two figures, in em, with a gap
constexpr double number_height = 1.15; // in em, with a gap
constexpr double most_space = 24;      // from bar to bar
constexpr double phase_bar = 1.2;      // length of a bar of card 3, in em
constexpr double least_length = 30;    // of a bar of cards 1 and 2

constexpr double bar_share = 0.8;         // the part of its space that a bar fills
constexpr double upright_share = 0.42;    // of the panel's longer side, that one block has
constexpr double half_of_a_number = 0.36; // half the height of a digit, in em
constexpr double least_pixels = 2;        // in a period
constexpr float background = 0.5f;        // the mean light of lines

// Bars are made for errors that are so many times the bounds: of a description, and of a reading.
constexpr double first_margin = 1.2, reading_margin = 2.5;
constexpr int least_bars = 7, enough_bars = 9, most_bars = 21; // of a block, for the eye to compare
constexpr double least_step = 0.125, greatest_step = 1;        // bands along a bar, from bar to bar

/// A rectangle, mm from the panel's left and top edges.
struct Box {
    double left, top, width, height;
    Vec2 middle() const { return {left + width / 2, top + height / 2}; }
};

Vec2 sheet_point_at(const Panel& panel, Vec2 mm)
{
    const Film& film = panel.film;
    return sheet_point_of(
        film_from_pixel(film, {mm.x / film.pixel_pitch.x, mm.y / film.pixel_pitch.y}), panel.sheet,
        panel.aperture.distance);
}

/// Throws std::invalid_argument if there is less room than needed, mm.
void demand_room(double have, double need, const char* side)
{
    if (have < need)
        throw std::invalid_argument(
            "the panel is too " + std::string(side) + " for bars and numbers that can be read " +
            "through its lenses: " + with_decimals(need - have, 1) +
            " mm more are needed; the card of views has room: from the viewing distance one "
            "number fills the panel where the pitch is right");
}

void set_place(const Film& film, const Box& box, LensBar& bar)
{
    set_rectangle(film, box.left, box.top, box.left + box.width, box.top + box.height, bar);
}

/// Number and steps of a block's bars.
struct Steps {
    int bars;
    double length; ///< of a bar, mm
    double step;   ///< from bar to bar, 1/mm
};

/// Steps for errors up to `range` (1/mm) of at most `most` bars that are at most `length` mm long.
Steps steps_for(double range, double length, int most)
{
    const int each_side = (most - 1) / 2;
    length = std::min(length, greatest_step * each_side / range);
    const double bands = std::max(least_step, range * length / each_side);
    const int steps = std::min(each_side, int(std::ceil(range * length / bands - 1e-9)));
    return {2 * steps + 1, length, bands / length};
}

/// The number of bars for which there is room on a block that is `across` ems of the smallest
/// numbers wide, or high if its bars lie. Numbers of upright bars stand in turn above and below and
/// may be two spaces wide, the outermost ones half a space wider than the block's bars. But bars
/// are as wide as a number where this leaves enough of them, because thin ones run together under
/// the lenses.
int most_in(double across, bool upright)
{
    if (!upright)
        return int(across);
    const int wide = int(across / number_width), narrow = int(2 * across / number_width) - 1;
    return std::max(wide, std::min(narrow, enough_bars));
}

/// A block of cards 1 and 2, without bars, for a part of the panel. `bars` becomes their number and
/// steps, and `space` mm from bar to bar.
LensBlock block_for(const LensCard& card, const Box& box, bool upright, Steps& bars, double& space)
{
    const double pitch = card.panel.sheet.pitch;
    const double across = upright ? box.width : box.height,
                 along = upright ? box.height : box.width;
    const double em_per_space = upright ? 2 / number_width : 1;
    const int more = upright ? 1 : 0;
    const double least_space = least_font / em_per_space * pitch;
    const double ends = 2 * (upright ? number_height : number_width) * largest_font * pitch;
    demand_room(across, (least_bars + more) * least_space, upright ? "narrow" : "low");
    demand_room(along, ends + least_length * pitch, upright ? "low" : "narrow");
    const double range = (card.number == 1 ? first_margin : reading_margin) *
                         (upright ? card.error.y : card.error.x);
    bars = steps_for(range, along - ends,
                     std::min(most_bars, most_in(across / (least_font * pitch), upright)));
    space = std::min(across / (bars.bars + more), most_space * pitch);
    LensBlock block;
    block.upright = upright;
    block.step = bars.step;
    block.font = std::min(largest_font * pitch, em_per_space * space);
    return block;
}

/// The same with its bars. Lying ones have their numbers at both ends, upright ones in turn above
/// and below.
LensBlock block_in(const LensCard& card, const Box& box, bool upright, int first_number)
{
    Steps bars;
    double space;
    LensBlock block = block_for(card, box, upright, bars, space);
    const Vec2 middle = box.middle();
    const double thick = bar_share * space, length = bars.length;
    const double label_at = (length + (upright ? number_height : number_width) * block.font) / 2;
    for (int k = 0; k < bars.bars; ++k) {
        const double place = k - (bars.bars - 1) / 2.0, shift = place * space;
        LensBar bar;
        bar.number = first_number + k;
        bar.wave = wave_vector(card.panel.sheet);
        (upright ? bar.wave.y : bar.wave.x) += place * bars.step;
        bar.origin = sheet_point_at(card.panel, middle);
        set_place(card.panel.film,
                  upright ? Box{middle.x + shift - thick / 2, middle.y - length / 2, thick, length}
                          : Box{middle.x - length / 2, middle.y + shift - thick / 2, length, thick},
                  bar);
        block.bars.push_back(bar);
        if (upright)
            block.labels.push_back(
                {middle.x + shift, middle.y + (k % 2 == 0 ? -label_at : label_at)});
        else
            for (const double end : {-label_at, label_at})
                block.labels.push_back({middle.x + end, middle.y + shift});
    }
    return block;
}

/// The rows of card 3: the number of bars, and the em of the numbers, mm.
struct PhaseRoom {
    int bars;
    double font;
    double across() const { return number_width * font; } // from bar to bar, side by side
    double down() const { return font; }                  // one below the other
    double length() const { return phase_bar * font; }    // of a bar, across its row

    /// Width and height that the rows need, without the panel's edges.
    Vec2 size() const
    {
        return {bars * across() + 2 * (length() + across()),
                std::max(bars * down(), 2 * (length() + 2 * font))};
    }
};

/// The rows with the most bars, and with the largest numbers, for which there is room.
PhaseRoom phase_room(const Panel& panel)
{
    const double pitch = panel.sheet.pitch, edges = 4 * margin * pitch;
    const Vec2 size = size_of(panel.film);
    PhaseRoom room{};
    for (const int bars : {12, 8})
        for (double font = largest_font; font >= least_font; font -= 0.5) {
            room = {bars, font * pitch};
            if (room.size().x + edges <= size.x && room.size().y + edges <= size.y)
                return room;
        }
    demand_room(size.x, room.size().x + edges, "narrow");
    demand_room(size.y, room.size().y + edges, "low");
    return room;
}

/// The rows of card 3: at the top, at the bottom, at the left and at the right.
std::vector<LensBlock> phase_blocks(const LensCard& card, const PhaseRoom& room)
{
    const Panel& panel = card.panel;
    const Vec2 size = size_of(panel.film);
    const double edge = margin * panel.sheet.pitch;
    std::vector<LensBlock> blocks;
    for (int side = 0; side < 4; ++side) {
        const bool row = side < 2, far = side % 2 == 1; // far: at the bottom, at the right
        LensBlock block;
        block.is_circle = true;
        block.step = 1.0 / room.bars;
        block.font = room.font;
        for (int k = 0; k < room.bars; ++k) {
            const double place = k - (room.bars - 1) / 2.0;
            LensBar bar;
            bar.number = side * room.bars + k + 1;
            bar.wave = wave_vector(panel.sheet);
            bar.phase = k * block.step;
            const double space = row ? room.across() : room.down(), thick = bar_share * space;
            const double middle = (row ? size.x : size.y) / 2 + place * space;
            const double whole = row ? size.y : size.x,
                         begin = far ? whole - edge - room.length() : edge,
                         label = (row ? number_height : number_width) * room.font / 2,
                         number = far ? begin - label : begin + room.length() + label;
            set_place(panel.film,
                      row ? Box{middle - thick / 2, begin, thick, room.length()}
                          : Box{begin, middle - thick / 2, room.length(), thick},
                      bar);
            block.bars.push_back(bar);
            block.labels.push_back(row ? Vec2{middle, number} : Vec2{number, middle});
        }
        blocks.push_back(block);
    }
    return blocks;
}

/// The mean of cos(2 pi u) over u within +-half_width, divided by cos of its middle.
double mean_of_cosine(double half_width)
{
    const double angle = 2 * pi * half_width;
    return angle > 1e-6 ? std::sin(angle) / angle : 1;
}

/// The light of a bar's lines. It changes like a cosine across them: under any lenses, one of two
/// halves that differ by a quarter of a period then shows a small change of phase. On card 3 it is
/// the square of that light, which has a narrower maximum.
class LineLight {
public:
    LineLight(const Panel& panel, const LensBar& bar, bool squared) : squared_(squared)
    {
        const Vec2 size = subpixel_size(panel.film.subpixels);
        const double a = std::fabs(bar.wave.x) * size.x * panel.film.pixel_pitch.x / 2,
                     b = std::fabs(bar.wave.y) * size.y * panel.film.pixel_pitch.y / 2;
        first_ = mean_of_cosine(a) * mean_of_cosine(b);
        second_ = mean_of_cosine(2 * a) * mean_of_cosine(2 * b);
    }

    /// The mean over a subpixel's area. `phase`: at its middle, 0 in a light line's middle.
    float operator()(double phase) const
    {
        const double cosine = std::cos(2 * pi * phase);
        return float(squared_ ? 0.375 + 0.5 * first_ * cosine +
                                    0.125 * second_ * (2 * cosine * cosine - 1)
                              : 0.5 + 0.5 * first_ * cosine);
    }

private:
    bool squared_;
    double first_, second_; ///< contrasts of the cosine and of its double frequency
};

/// Draws a row of a bar's pixels. Of `halves`, the lines of the bar's second half, lower or right,
/// are shifted by a quarter.
void draw_row(const Panel& panel, const LensBar& bar, int y, bool halves, bool upright,
              const LinearWriter& write)
{
    const Film& film = panel.film;
    const LineLight light_of(panel, bar, !halves);
    for (int x = bar.left; x < bar.left + bar.width; ++x) {
        const Vec2 middle = film_from_pixel(film, {x + 0.5, y + 0.5});
        const double scale = pitch_of_visual(1, panel.sheet, panel.aperture.distance,
                                             length(middle));
        const bool second = halves && (upright ? x >= bar.left + bar.width / 2
                                               : y >= bar.top + bar.height / 2);
        float light[3];
        for (int channel = 0; channel < 3; ++channel) {
            const Vec2 place = film_from_pixel(film,
                                               subpixel_centre(film.subpixels, x, y, channel));
            const double phase = dot(bar.wave, scale * place - bar.origin) - bar.phase -
                                 (second ? 0.25 : 0);
            light[channel] = light_of(phase);
        }
        write(x, y, {light[0], light[1], light[2], 1});
    }
}

void check_lines(const Panel& panel)
{
    const Vec2 wave = wave_vector(panel.sheet), pixel = panel.film.pixel_pitch;
    if (least_pixels * std::max(std::fabs(wave.x) * pixel.x, std::fabs(wave.y) * pixel.y) > 1)
        throw std::invalid_argument("lenses " + with_decimals(panel.sheet.pitch, 4) +
                                    " mm wide are less than 2 pixels wide; a finer panel is "
                                    "needed");
}

/// Writes the numbers of a block's bars.
void write_numbers(const LensBlock& block, Vec2 pixel_pitch, Image& image)
{
    const DeviceFont font{block.font, true};
    const std::size_t each = block.labels.size() / block.bars.size();
    for (std::size_t k = 0; k < block.labels.size(); ++k) {
        const std::string number = std::to_string(block.bars[k / each].number);
        const Vec2 middle = block.labels[k];
        write_text(
            image, pixel_pitch, number,
            {middle.x - text_width(number, font) / 2, middle.y + half_of_a_number * font.size},
            font);
    }
}

std::string numbers_of(const LensBlock& block)
{
    return std::to_string(block.bars.front().number) + " to " +
           std::to_string(block.bars.back().number);
}

} // namespace

LensCard first_lens_card(const Panel& panel)
{
    if (panel.sheet.arrangement != Arrangement::lenticular)
        throw std::invalid_argument("its lenses are not lenticular; readings are for those");
    LensCard card;
    card.panel = panel;
    const Vec2 wave = wave_vector(panel.sheet);
    const double turn = first_slant_error * radians_per_degree;
    card.error = {first_pitch_error * std::fabs(wave.x) + turn * std::fabs(wave.y),
                  first_pitch_error * std::fabs(wave.y) + turn * std::fabs(wave.x)};
    return card;
}

Vec2 wave_vector(const LensSheet& sheet) { return 1 / sheet.pitch * Lattice(sheet).across(); }

Vec2 sheet_point_of(Vec2 film_point, const LensSheet& sheet, double distance)
{
    // |P| differs from |F| by a few thousandths, on which the magnification hardly depends.
    const double near = pitch_of_visual(1, sheet, distance, length(film_point));
    return pitch_of_visual(1, sheet, distance, near * length(film_point)) * film_point;
}

std::vector<LensBlock> lens_blocks(const LensCard& card)
{
    check_lines(card.panel);
    const PhaseRoom room = phase_room(card.panel); // or else there is no use in the first card
    if (card.number >= lens_cards)
        return phase_blocks(card, room);
    const Vec2 size = size_of(card.panel.film);
    const double edge = margin * card.panel.sheet.pitch;
    // The blocks lie side by side along the panel's longer side.
    const bool wide = size.x >= size.y;
    const double share = (wide ? size.x : size.y) * upright_share;
    const Box first = wide ? Box{edge, edge, share - 1.5 * edge, size.y - 2 * edge}
                           : Box{edge, edge, size.x - 2 * edge, share - 1.5 * edge};
    const Box second = wide ? Box{share + edge / 2, edge, size.x - share - 1.5 * edge,
                                  size.y - 2 * edge}
                            : Box{edge, share + edge / 2, size.x - 2 * edge,
                                  size.y - share - 1.5 * edge};
    LensBlock lying = block_in(card, wide ? second : first, false, 1);
    LensBlock upright = block_in(card, wide ? first : second, true, int(lying.bars.size()) + 1);
    return {std::move(lying), std::move(upright)};
}

Image lens_card_picture(const LensCard& card)
{
    const Film& film = card.panel.film;
    const std::vector<LensBlock> blocks = lens_blocks(card);
    Image image = make_image<std::uint8_t>(film.width, film.height, 3, {});
    const LinearWriter write(image);
    for_each_row(film.height, 0, [&](int y) {
        for (int x = 0; x < film.width; ++x)
            write(x, y, {background, background, background, 1});
        for (const LensBlock& block : blocks)
            for (const LensBar& bar : block.bars)
                if (y >= bar.top && y < bar.top + bar.height)
                    draw_row(card.panel, bar, y, !block.is_circle, block.upright, write);
    });
    for (const LensBlock& block : blocks)
        write_numbers(block, film.pixel_pitch, image);
    return image;
}

std::string lens_card_advice(const LensCard& card)
{
    const std::vector<LensBlock> blocks = lens_blocks(card);
    const std::string from = "Look with one eye from straight in front of the middle, " +
                             with_digits(card.panel.aperture.distance, 4) + " mm away. ";
    if (card.number < lens_cards)
        return from + "Which of the lying bars " + numbers_of(blocks[0]) +
               " is even from end to end, or the most even? Which of the upright bars " +
               numbers_of(blocks[1]) +
               "? The bands of bars on either side of it lean to opposite sides. Two that are "
               "equally even both count, as 7,8.";
    return from + "Which bar is the brightest at the top (" + numbers_of(blocks[0]) +
           "), at the bottom (" + numbers_of(blocks[1]) + "), at the left (" +
           numbers_of(blocks[2]) + ") and at the right (" + numbers_of(blocks[3]) +
           ")? Its neighbours on either side are equally dark. Two that are equally bright both "
           "count; the last and the first of a row are neighbours.";
}

} // namespace integral
