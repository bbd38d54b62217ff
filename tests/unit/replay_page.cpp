// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the parts of the interactive page. tests/cli/replay_html.test shows the page in a browser.
#include "integral/base/json.h"
#include "integral/io/codecs.h"
#include "integral/replay/arrange.h"
#include "integral/replay/replay_page.h"

#include "tests/unit/replay_frames.h"

#include <boost/test/unit_test.hpp>

#include <string>

using namespace integral;

BOOST_AUTO_TEST_SUITE(replay_pages)

namespace {

/// The part of the page between two texts.
std::string between(const std::string& page, const std::string& before, const std::string& after)
{
    const auto from = page.find(before);
    BOOST_REQUIRE(from != std::string::npos);
    const auto to = page.find(after, from + before.size());
    BOOST_REQUIRE(to != std::string::npos);
    return page.substr(from + before.size(), to - from - before.size());
}

/// Decodes base64, strictly by RFC 4648.
std::string from_base64(const std::string& text)
{
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    BOOST_REQUIRE_EQUAL(text.size() % 4, 0);
    const std::size_t end = text.find('='),
                      padding = end == std::string::npos ? 0 : text.size() - end;
    BOOST_REQUIRE(padding <= 2);
    std::string bytes;
    unsigned bits = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto digit = digits.find(text[i]);
        BOOST_REQUIRE(i >= text.size() - padding || digit != std::string::npos);
        bits = bits << 6 | unsigned(i < text.size() - padding ? digit : 0);
        if (i % 4 == 3)
            for (int shift = 16; shift >= 0; shift -= 8)
                bytes += char(bits >> shift & 255);
    }
    return bytes.substr(0, bytes.size() - padding);
}

template <class Sample> Frame noise(int width, int height, int channels, Encoding encoding)
{
    Frame frame;
    frame.image = make_image<Sample>(width, height, channels, encoding);
    unsigned n = 1;
    const auto next = [&] { return float((n = n * 1664525u + 1013904223u) >> 8) / (1 << 24); };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            store_pixel(frame.image, x, y, {next(), next(), next(), next()});
    set_metadata(frame, geometry(cases[0], width, height, 0.1));
    return frame;
}

/// The page that begins with the eye at the aperture's centre.
std::string page_of(const Frame& frame)
{
    View start;
    start.eye = centre_eye(*frame.metadata);
    return replay_page(frame, start);
}

void check_frame(const Frame& frame)
{
    const std::string page = page_of(frame);
    const Image got = decode_png(from_base64(between(page, "data:image/png;base64,", "\""))).image;
    const Image requested = converted(frame.image, 8, Encoding{}, false);
    BOOST_TEST(got.channels == requested.channels);
    BOOST_TEST((got.samples == requested.samples));
}

} // namespace

BOOST_AUTO_TEST_CASE(holds_the_frame_at_8_bits, *boost::unit_test::label("many_pixels"))
{
    for (int width = 1; width < 12; ++width) { // every remainder of base64's three bytes
        check_frame(noise<std::uint8_t>(width, 5, 3, {}));
        check_frame(noise<std::uint16_t>(width, 5, 4, {Encoding::Kind::power, 2.2}));
        check_frame(noise<float>(width, 5, 4, linear));
    }
}

BOOST_AUTO_TEST_CASE(holds_geometry_and_start)
{
    Frame frame = noise<std::uint8_t>(7, 5, 3, {});
    frame.metadata->render.emplace();
    const std::string name = "</script><!-- \"&amp;\" @FRAME@ @SCRIPT@ \xe2\x80\xa8 \xc3\xa9.pov";
    frame.metadata->render->scene = name;
    View start;
    start.eye = {1.5, -2, 300};
    start.pupil = 4;
    start.focus = -8;
    start.film_gap = 0.1;
    start.blur = 0.2;
    start.samples = 5;
    start.part = {{1, -2}, 30, 20};
    start.model = LensModel::pinhole;
    const std::string page = replay_page(frame, start);

    const std::string json = between(page, "<script type=\"application/json\" id=\"geometry\">",
                                     "</script>");
    BOOST_TEST(json.find('<') == std::string::npos);
    const FrameMetadata read = frame_metadata_from_json(json);
    BOOST_TEST(read.render->scene == name);
    BOOST_TEST(read.sheet.pitch == frame.metadata->sheet.pitch);
    BOOST_TEST(read.film.width == 7);

    const auto view = Json::parse(
        between(page, "<script type=\"application/json\" id=\"start\">", "</script>"));
    auto requested = Json::parse(
        R"({"eye": [1.5, -2, 300], "size": [0, 0], "samples": 5, "pupil": 4,
                                                 "focus": -8, "film_gap": 0.1, "blur": 0.2, "model": "pinhole",
                                                 "part": [1, -2, 30, 20], "zone": [0, 0]})");
    const Vec2 zone = viewing_zone(*frame.metadata, 300);
    requested["zone"] = {zone.x, zone.y};
    BOOST_TEST(view == requested);
}

BOOST_AUTO_TEST_CASE(has_no_mark_left)
{
    const std::string page = page_of(noise<std::uint8_t>(3, 3, 3, {}));
    for (const char* mark : {"@FRAME@", "@GEOMETRY@", "@START@", "@SHADER@", "@SCRIPT@"})
        BOOST_TEST(page.find(mark) == std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
