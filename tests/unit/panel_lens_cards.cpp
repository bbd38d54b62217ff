// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the cards by which the eye measures a panel's lenses: that the cards' lines lie as the
// optics require, and that readings of ideal eyes give pitch, slant and phase.
#include "integral/panel/lens_readings.h"

#include "integral/optics/lens_mapping.h"
#include "integral/optics/visual_pitch.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

using namespace integral;

BOOST_AUTO_TEST_SUITE(panel_lens_cards)

namespace {

constexpr double degree = 3.14159265358979323846 / 180, turn = 360 * degree;

Panel panel_of(double pitch, double slant, int width = 1920, int height = 1080)
{
    Panel panel;
    panel.film = {width, height, {0.25, 0.25}, Subpixels::rgb};
    panel.sheet.pitch = pitch;
    panel.sheet.thickness = 2.2 * pitch;
    panel.sheet.ior = 1.56;
    panel.sheet.slant = slant;
    panel.aperture = *filling_aperture(panel.sheet, 600);
    return panel;
}

/// The wave vector of lenses, by its definition.
Vec2 wave_of(double pitch, double slant)
{
    return {std::cos(slant * degree) / pitch, std::sin(slant * degree) / pitch};
}

/// The bar for which `off`, in steps, is least; and the next one, if both look the same to an eye
/// that distinguishes half steps.
template <class Off> std::vector<int> select(const LensBlock& block, Off off)
{
    std::vector<std::pair<double, int>> bars;
    for (const LensBar& bar : block.bars)
        bars.push_back({std::fabs(off(bar)), bar.number});
    std::sort(bars.begin(), bars.end());
    if (bars[1].first - bars[0].first < 0.5)
        return {bars[0].second, bars[1].second};
    return {bars[0].second};
}

/// The bars that are even to an ideal eye, of a block of card 1 or 2.
std::vector<int> even_bars(const LensBlock& block, Vec2 wave)
{
    return select(block, [&](const LensBar& bar) {
        return (block.upright ? bar.wave.y - wave.y : bar.wave.x - wave.x) / block.step;
    });
}

Vec2 middle_of(const Panel& panel, const LensBar& bar)
{
    return sheet_point_of(
        film_from_pixel(panel.film, {bar.left + bar.width / 2.0, bar.top + bar.height / 2.0}),
        panel.sheet, panel.aperture.distance);
}

/// The brightest bars of a row of card 3: their lines lie nearest to the axes, whose points have
/// wave.P = phase modulo 1.
std::vector<int> brightest_bars(const Panel& panel, const LensBlock& block, Vec2 wave, double phase)
{
    return select(block, [&](const LensBar& bar) {
        const double beside = dot(bar.wave - wave, middle_of(panel, bar)) + phase - bar.phase;
        return (beside - std::round(beside)) / block.step;
    });
}

std::vector<int> ideal_reading(const LensCard& card, Vec2 wave, double phase)
{
    std::vector<int> bars;
    for (const LensBlock& block : lens_blocks(card))
        for (const int bar : block.is_circle ? brightest_bars(card.panel, block, wave, phase)
                                             : even_bars(block, wave))
            bars.push_back(bar);
    return bars;
}

std::string refusal_of(const LensCard& card, const std::vector<int>& bars)
{
    try {
        card_after(card, bars);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

} // namespace

BOOST_AUTO_TEST_CASE(the_sheet_point_of_an_axis_s_image_is_on_the_axis)
{
    for (const double slant : {0.0, 9.46, -18.4, 80.0}) {
        const Panel panel = panel_of(1.5, slant);
        const SheetOptics optics(panel.sheet, panel.aperture);
        const double distance = panel.aperture.distance;
        for (const double across : {-150.0, -3.0, 0.0, 90.0, 180.0})
            for (const double along : {-100.0, 0.0, 60.0}) {
                // A point of the axis number across / 1.5.
                const Vec2 axis = across * panel.sheet.pitch * wave_of(1.5, slant) +
                                  along * Vec2{-std::sin(slant * degree), std::cos(slant * degree)};
                const Vec2 film = optics.film_point_seen(axis, {-axis.x, -axis.y, -distance});
                const Vec2 back = sheet_point_of(film, panel.sheet, distance);
                BOOST_TEST(length(back - axis) < 1e-4);
            }
    }
}

BOOST_AUTO_TEST_CASE(ideal_readings_give_pitch_slant_and_phase)
{
    std::mt19937 random(1);
    const auto within = [&](double a, double b) {
        return std::uniform_real_distribution<double>(a, b)(random);
    };
    for (int k = 0; k < 200; ++k) {
        const bool portrait = k % 4 == 3;
        const double pitch = within(0.8, 1.3),
                     slant = k % 5 == 4 ? within(-89, 89) : within(-20, 20);
        const double phase = within(-0.5, 0.5);
        const Vec2 wave = wave_of(pitch, slant);
        LensCard card = first_lens_card(panel_of(pitch * (1 + within(-0.01, 0.01)),
                                                 std::clamp(slant + within(-1.5, 1.5), -90., 90.),
                                                 portrait ? 1080 : 1920, portrait ? 1920 : 1080));
        for (int number = 1; number <= 3; ++number) {
            BOOST_TEST(card.number == number);
            card = card_after(card, ideal_reading(card, wave, phase));
            const Vec2 off = wave_vector(card.panel.sheet) - wave;
            // An ideal reading is right to a quarter of a step, and the bounds are for a half. On
            // card 3 the phases of a row's ends do not join exactly.
            const double part = number < 3 ? 0.51 : 1;
            BOOST_TEST(std::fabs(off.x) <= part * card.error.x);
            BOOST_TEST(std::fabs(off.y) <= part * card.error.y);
        }
        // Where some 200 lenses, not 400, are counted, errors may be twice as large.
        const double part = portrait || std::fabs(slant) > 20 ? 2 : 1;
        BOOST_TEST(std::fabs(card.panel.sheet.pitch / pitch - 1) < part * 2.5e-4);
        BOOST_TEST(std::fabs(card.panel.sheet.slant - slant) < part * 0.02);
        const double found = dot(card.panel.sheet.offset, wave) - phase;
        BOOST_TEST(std::fabs(found - std::round(found)) < 1 / 40.0);
    }
}

BOOST_AUTO_TEST_CASE(neighbours_that_look_the_same_count_as_their_middle)
{
    const LensCard card = first_lens_card(panel_of(1.2, 9));
    const auto blocks = lens_blocks(card);
    const int lying = blocks[0].bars[4].number, upright = blocks[1].bars[1].number;
    const Vec2 one = wave_vector(card_after(card, {lying, upright}).panel.sheet),
               both = wave_vector(card_after(card, {upright, lying + 1, lying}).panel.sheet);
    BOOST_TEST(both.x - one.x == blocks[0].step / 2, boost::test_tools::tolerance(1e-6));
    BOOST_TEST(both.y == one.y, boost::test_tools::tolerance(1e-12));
    // Of a row of the last card, the first bar is next to the last one.
    LensCard last = card;
    last.number = 3;
    const int bars = int(lens_blocks(last)[0].bars.size());
    std::vector<int> numbers;
    for (int side = 0; side < 4; ++side) {
        numbers.push_back(side * bars + 1);
        numbers.push_back(side * bars + bars);
    }
    const Panel panel = card_after(last, numbers).panel;
    BOOST_TEST(dot(panel.sheet.offset, wave_vector(panel.sheet)) == -0.5 / bars,
               boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(subpixels_have_the_mean_light_of_their_areas)
{
    for (const int number : {1, 3}) {
        LensCard card = first_lens_card(panel_of(1.3, 12));
        card.number = number;
        const Panel& panel = card.panel;
        const Image picture = lens_card_picture(card);
        const LinearReader light(picture);
        for (const LensBlock& block : lens_blocks(card)) {
            const LensBar& bar = block.bars[2];
            for (int k = 0; k < 6; ++k) { // from one corner to the opposite one
                const int x = bar.left + k * (bar.width - 1) / 5,
                          y = bar.top + (5 - k) * (bar.height - 1) / 5;
                const bool second = number == 1 && (block.upright ? x >= bar.left + bar.width / 2
                                                                  : y >= bar.top + bar.height / 2);
                double mean[3] = {0, 0, 0};
                constexpr int parts = 12;
                for (int i = 0; i < 3 * parts * parts; ++i) {
                    const int channel = i / (parts * parts);
                    const Vec2 at{x + (channel + (i % parts + 0.5) / parts) / 3,
                                  y + (i / parts % parts + 0.5) / parts};
                    const Vec2 film{(at.x - 960) * 0.25, (540 - at.y) * 0.25};
                    const Vec2 place = pitch_of_visual(1, panel.sheet, 600, length(film)) * film;
                    const double phase = dot(bar.wave, place - bar.origin) - bar.phase -
                                         (second ? 0.25 : 0);
                    const double wave = 0.5 + 0.5 * std::cos(turn * phase);
                    mean[channel] += (number == 1 ? wave : wave * wave) / (parts * parts);
                }
                const Colour drawn = light(x, y);
                BOOST_TEST(std::fabs(drawn.r - mean[0]) < 0.008);
                BOOST_TEST(std::fabs(drawn.g - mean[1]) < 0.008);
                BOOST_TEST(std::fabs(drawn.b - mean[2]) < 0.008);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(all_bars_of_a_block_have_the_same_phase_in_their_middles)
{
    const LensCard card = first_lens_card(panel_of(1.2, -15));
    const Vec2 wave = wave_of(1.2, -15);
    for (const LensBlock& block : lens_blocks(card))
        for (const LensBar& bar : block.bars)
            BOOST_TEST(std::fabs(dot(bar.wave - wave, middle_of(card.panel, bar) - bar.origin)) <
                       0.01);
}

BOOST_AUTO_TEST_CASE(rows_are_at_the_sides_that_their_order_means)
{
    LensCard card = first_lens_card(panel_of(1.2, 9));
    card.number = 3;
    const auto blocks = lens_blocks(card);
    BOOST_REQUIRE(blocks.size() == 4);
    for (const LensBar& bar : blocks[0].bars)
        BOOST_TEST(bar.top + bar.height < 1080 / 4);
    for (const LensBar& bar : blocks[1].bars)
        BOOST_TEST(bar.top > 3 * 1080 / 4);
    for (const LensBar& bar : blocks[2].bars)
        BOOST_TEST(bar.left + bar.width < 1920 / 4);
    for (const LensBar& bar : blocks[3].bars)
        BOOST_TEST(bar.left > 3 * 1920 / 4);
}

BOOST_AUTO_TEST_CASE(bars_are_wide_where_there_is_room)
{
    const auto blocks = lens_blocks(first_lens_card(panel_of(1.2, 9)));
    for (const LensBar& bar : blocks[1].bars)
        BOOST_TEST(bar.width * 0.25 > 9 * 1.2);
    for (const LensBar& bar : blocks[0].bars)
        BOOST_TEST(bar.height * 0.25 > 6 * 1.2);
}

BOOST_AUTO_TEST_CASE(bars_and_numbers_do_not_overlap_and_lie_on_the_panel)
{
    for (const Vec2 size : {Vec2{1920, 1080}, {1080, 1920}, {900, 700}, {3000, 1000}})
        for (const double slant : {0.0, 30.0, -88.0})
            for (int number = 1; number <= 3; ++number) {
                LensCard card = first_lens_card(panel_of(1.1, slant, int(size.x), int(size.y)));
                card.number = number;
                struct Box {
                    double left, top, right, bottom;
                };
                std::vector<Box> boxes; // of bars and of numbers of two figures, pixels
                for (const LensBlock& block : lens_blocks(card)) {
                    for (const LensBar& bar : block.bars)
                        boxes.push_back({double(bar.left), double(bar.top),
                                         double(bar.left + bar.width),
                                         double(bar.top + bar.height)});
                    for (const Vec2 label : block.labels) {
                        const Vec2 half = 4 * block.font * Vec2{0.7, 0.36};
                        boxes.push_back({4 * label.x - half.x, 4 * label.y - half.y,
                                         4 * label.x + half.x, 4 * label.y + half.y});
                    }
                }
                int overlaps = 0, outside = 0;
                for (std::size_t i = 0; i < boxes.size(); ++i) {
                    const Box& a = boxes[i];
                    outside += a.left < 0 || a.top < 0 || a.right > size.x || a.bottom > size.y;
                    for (std::size_t j = 0; j < i; ++j)
                        overlaps += a.left < boxes[j].right && boxes[j].left < a.right &&
                                    a.top < boxes[j].bottom && boxes[j].top < a.bottom;
                }
                BOOST_TEST(overlaps == 0);
                BOOST_TEST(outside == 0);
            }
}

BOOST_AUTO_TEST_CASE(readings_that_make_no_sense_are_refused)
{
    const LensCard card = first_lens_card(panel_of(1.2, 9));
    const int lying = int(lens_blocks(card)[0].bars.size());
    const auto says = [](const std::string& text, const char* words) {
        return text.find(words) != std::string::npos;
    };
    BOOST_TEST(says(refusal_of(card, {1}), "is missing"));
    BOOST_TEST(says(refusal_of(card, {1, 3, lying + 1}), "must be neighbours"));
    BOOST_TEST(says(refusal_of(card, {0, lying + 1}), "card 1 has bars 1 to "));
    BOOST_TEST(says(refusal_of(card, {1, 1000}), ", not 1000"));
    LensCard last = card;
    last.number = 3;
    const int bars = int(lens_blocks(last)[0].bars.size());
    BOOST_TEST(says(refusal_of(last, {1, bars + 1, 2 * bars + 5, 3 * bars + 5}), "contradict"));
    BOOST_TEST(says(refusal_of(last, {1, bars + 1 + bars / 2, 2 * bars + 1, 3 * bars + 1}),
                    "read card 2 again"));
    LensCard done = last;
    done.number = 4;
    BOOST_TEST(says(refusal_of(done, {1}), "there are 3 cards"));

    Panel round = panel_of(1.2, 9);
    round.sheet.arrangement = Arrangement::square;
    BOOST_CHECK_THROW(first_lens_card(round), std::invalid_argument);
    for (const Vec2 size : {Vec2{200, 1080}, Vec2{1920, 100}})
        for (const int number : {1, 3}) {
            LensCard small = first_lens_card(panel_of(1.2, 9, int(size.x), int(size.y)));
            small.number = number;
            BOOST_CHECK_THROW(lens_blocks(small), std::invalid_argument);
        }
    BOOST_CHECK_THROW(lens_blocks(first_lens_card(panel_of(0.4, 0))), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_zone_of_the_description_s_own_is_kept)
{
    Panel panel = panel_of(1.2, 9);
    const auto after = [](const Panel& rough) {
        const LensCard card = first_lens_card(rough);
        const int lying = int(lens_blocks(card)[0].bars.size());
        return card_after(card, {1, lying + 1}).panel;
    };
    const Panel filled = after(panel);
    BOOST_TEST(filled.aperture.width == filling_aperture(filled.sheet, 600)->width,
               boost::test_tools::tolerance(1e-12));
    panel.aperture.width = 123;
    BOOST_TEST(after(panel).aperture.width == 123);
}

BOOST_AUTO_TEST_SUITE_END()
