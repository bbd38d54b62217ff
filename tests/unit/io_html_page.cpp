// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the parts of HTML pages: escaped text, links, reduced pictures.
#include "integral/io/html_page.h"
#include "integral/io/markup.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstdint>

using namespace integral;

BOOST_AUTO_TEST_SUITE(io_html_page)

BOOST_AUTO_TEST_CASE(text_is_escaped)
{
    BOOST_TEST(markup_text("a <b> & \"c\" 'd'") == "a &lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;");
    BOOST_TEST(markup_text("tab\tline\nreturn\r") == "tab&#9;line&#10;return&#13;");
    BOOST_TEST(markup_text("Größe, 日本, \xf0\x9f\x98\x80") == "Größe, 日本, \xf0\x9f\x98\x80");
    // Controls, a lone byte, an overlong '<', half a surrogate pair, beyond Unicode, a character
    // cut off, U+FFFE.
    const std::string instead = "\xef\xbf\xbd";
    BOOST_TEST(markup_text(std::string("\x1b[\0", 3)) == instead + "[" + instead);
    BOOST_TEST(markup_text("\xff") == instead);
    BOOST_TEST(markup_text("\xc0\xbc") == instead + instead);
    BOOST_TEST(markup_text("\xed\xa0\x80") == instead + instead + instead);
    BOOST_TEST(markup_text("\xf4\x90\x80\x80") == instead + instead + instead + instead);
    BOOST_TEST(markup_text("\xe2\x82") == instead + instead);
    BOOST_TEST(markup_text("\xef\xbf\xbe") == instead + instead + instead);
}

BOOST_AUTO_TEST_CASE(words_for_a_shell)
{
    const char* pairs[][2] = {{"frames/a-1_b.png", "frames/a-1_b.png"},
                              {"", "''"},
                              {"my room.png", "'my room.png'"},
                              {"a*;$b", "'a*;$b'"},
                              {"Bob's", "'Bob'\\''s'"}};
    for (const auto& pair : pairs)
        BOOST_TEST(for_shell(pair[0]) == pair[1]);
}

BOOST_AUTO_TEST_CASE(base64_of_the_rfc)
{
    const char* pairs[][2] = {{"", ""},        {"f", "Zg=="},        {"fo", "Zm8="},
                              {"foo", "Zm9v"}, {"foob", "Zm9vYg=="}, {"\xff\xfe", "//4="}};
    for (const auto& pair : pairs)
        BOOST_TEST(base64(pair[0]) == pair[1]);
}

BOOST_AUTO_TEST_CASE(links)
{
    BOOST_TEST(link_to("a b/c%#?.png") == "./a%20b/c%25%23%3F.png");
    BOOST_TEST(link_to("../ä.png") == "../%C3%A4.png");
    BOOST_TEST(link_to("javascript:x") == "./javascript%3Ax");
    BOOST_TEST(link_to("/a\"<") == "/a%22%3C");
}

BOOST_AUTO_TEST_CASE(scaling_averages_light)
{
    // 7 x 2 pixels to 3 x 1: columns 0-1, 2-3 and 4-6. Black and white give half the light, 188 of
    // 255 in sRGB.
    Image picture = make_image<std::uint16_t>(7, 2, 4, Encoding{});
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 7; ++x)
            store_pixel(
                picture, x, y,
                {x == 1 ? 1.0f : 0.0f, x == 2 || x == 3 ? 1.0f : 0.0f, 1, x < 4 ? 1.0f : 0.0f});
    const Image small = scaled_down(picture, 3);
    BOOST_TEST(small.width == 3);
    BOOST_TEST(small.height == 1);
    BOOST_TEST(small.channels == 3);
    BOOST_TEST(sample_bits(small) == 8);
    const auto& samples = std::get<std::vector<std::uint8_t>>(small.samples);
    const std::vector<int> got(samples.begin(), samples.end()),
        requested = {188, 0, 255, 0, 255, 255, 0, 0, 0}; // transparent: black
    BOOST_TEST(got == requested, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(scaling_keeps_the_greatest)
{
    Image picture = make_image<std::uint8_t>(40, 30, 3, Encoding{});
    store_pixel(picture, 13, 29, {0.2f, 0, 0, 1});
    store_pixel(picture, 12, 28, {0, 1, 0, 1});
    const Image small = scaled_down(picture, 4, Scaling::greatest); // 4 x 3: pixel (1, 2) has both
    BOOST_TEST(small.height == 3);
    std::vector<int> requested(36, 0), got;
    requested[(2 * 4 + 1) * 3] = 51;
    requested[(2 * 4 + 1) * 3 + 1] = 255;
    for (const std::uint8_t sample : std::get<std::vector<std::uint8_t>>(small.samples))
        got.push_back(sample);
    BOOST_TEST(got == requested, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(small_pictures_stay)
{
    Image picture = make_image<std::uint8_t>(5, 3, 3, Encoding{});
    for (int i = 0; i < 45; ++i)
        std::get<std::vector<std::uint8_t>>(picture.samples)[std::size_t(i)] = std::uint8_t(5 * i);
    const Image same = scaled_down(picture, 100);
    BOOST_TEST((same.samples == picture.samples));
    BOOST_TEST(scaled_down(picture, 1).width == 1);
    BOOST_TEST(
        picture_element(picture, 100, "a<b").find("width=\"5\" height=\"3\" alt=\"a&lt;b\"") !=
        std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_page)
{
    const std::string page = html_page("</title><script>", "b { color: red }", "<p>text</p>\n");
    BOOST_TEST(page.find("<title>&lt;/title&gt;&lt;script&gt;</title>") != std::string::npos);
    BOOST_TEST(page.find("<main>\n<p>text</p>\n</main>") != std::string::npos);
    BOOST_TEST(page.find("http:") == std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
