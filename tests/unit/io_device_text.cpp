// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests that text on a page has the right size, whatever the size and shape of the device's pixels.
#include "integral/io/device_text.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace integral;

BOOST_AUTO_TEST_SUITE(io_device_text)

namespace {

/// The box around all pixels that are darker than half, mm from the left and top edges.
struct Extent {
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
};

Extent extent_of(Vec2 pitch, Vec2 at, bool upwards)
{
    Image page = make_image<std::uint8_t>(int(60 / pitch.x), int(60 / pitch.y), 3, {});
    auto& samples = std::get<std::vector<std::uint8_t>>(page.samples);
    std::fill(samples.begin(), samples.end(), std::uint8_t(255));
    write_text(page, pitch, "HHHHHH", at, {5, true}, upwards);
    Extent extent;
    for (int y = 0; y < page.height; ++y)
        for (int x = 0; x < page.width; ++x)
            if (stored_pixel(page, x, y).g < 0.5f) {
                extent.left = std::min(extent.left, x * pitch.x);
                extent.right = std::max(extent.right, (x + 1) * pitch.x);
                extent.top = std::min(extent.top, y * pitch.y);
                extent.bottom = std::max(extent.bottom, (y + 1) * pitch.y);
            }
    return extent;
}

} // namespace

BOOST_AUTO_TEST_CASE(words_are_as_large_on_every_device)
{
    const Extent fine = extent_of({0.02, 0.02}, {10, 30}, false);
    BOOST_TEST(std::fabs(fine.bottom - 30) < 0.05); // capitals stand on the baseline
    BOOST_TEST(fine.left >= 10);
    BOOST_TEST(fine.right <= 10 + text_width("HHHHHH", {5, true}));
    BOOST_TEST(fine.right - fine.left > 0.8 * text_width("HHHHHH", {5, true}));
    const Extent coarse = extent_of({0.1, 0.05}, {10, 30}, false);
    BOOST_TEST(std::fabs(coarse.left - fine.left) < 0.11);
    BOOST_TEST(std::fabs(coarse.right - fine.right) < 0.11);
    BOOST_TEST(std::fabs(coarse.top - fine.top) < 0.06);
    BOOST_TEST(std::fabs(coarse.bottom - fine.bottom) < 0.06);
}

BOOST_AUTO_TEST_CASE(words_upwards_are_turned_a_quarter_to_the_left)
{
    const Extent level = extent_of({0.02, 0.04}, {10, 50}, false),
                 upwards = extent_of({0.04, 0.02}, {10, 50}, true);
    BOOST_TEST(std::fabs((50 - upwards.bottom) - (level.left - 10)) < 0.05);
    BOOST_TEST(std::fabs((50 - upwards.top) - (level.right - 10)) < 0.05);
    BOOST_TEST(std::fabs((10 - upwards.left) - (50 - level.top)) < 0.05);
}

BOOST_AUTO_TEST_CASE(words_past_the_page_are_cut_off)
{
    for (const Vec2 at : {Vec2{-3, 2}, Vec2{58, 30}, Vec2{5, 61}, Vec2{-500, -500}, Vec2{500, 500}})
        for (const bool upwards : {false, true})
            extent_of({0.1, 0.1}, at, upwards);
}

BOOST_AUTO_TEST_CASE(lines_are_broken_at_spaces)
{
    const std::string
        text = "one two three four five six seven eight averylongwordthatstayswhole nine";
    std::string joined;
    for (const std::string& line : wrapped(text, 12, {2, false})) {
        BOOST_TEST((text_width(line, {2, false}) <= 12 || line.find(' ') == std::string::npos),
                   line);
        joined += (joined.empty() ? "" : " ") + line;
    }
    BOOST_TEST(joined == text);
    BOOST_TEST(wrapped("", 12, {}).empty());
    BOOST_CHECK_THROW(text_width("\xff\xfe", {}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
