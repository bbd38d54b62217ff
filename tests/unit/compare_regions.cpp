// SPDX-License-Identifier: AGPL-3.0-or-later
// Checks ignored and weighted regions, and the share of differing pixels.
#include "integral/compare/compare.h"
#include "integral/compare/compare_limits.h"
#include "integral/compare/tolerances.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <stdexcept>

using namespace integral;

BOOST_AUTO_TEST_SUITE(compare_regions)

namespace {

const auto exactly = boost::test_tools::tolerance(1e-6);

Frame flat(int width, int height, float grey)
{
    Frame frame{make_image<float>(width, height, 3, {Encoding::Kind::linear, 1}), {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            store_pixel(frame.image, x, y, {grey, grey, grey, 1});
    return frame;
}

ComparisonSettings settings_with(const std::vector<Region>& regions, const Frame& frame)
{
    ComparisonSettings settings;
    settings.weights = std::make_shared<PixelWeights>(regions, std::nullopt, frame.image.width,
                                                      frame.image.height, frame.metadata);
    return settings;
}

std::string refusal_of(const std::string& words)
{
    try {
        region_of(words, 0);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

std::string document_refusal(const std::string& text)
{
    try {
        tolerances_from_json(text);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

} // namespace

BOOST_AUTO_TEST_CASE(differences_in_an_ignored_rectangle_do_not_count)
{
    const Frame a = flat(40, 30, 0.5f);
    Frame b = a;
    for (int y = 10; y < 20; ++y)
        for (int x = 10; x < 20; ++x)
            store_pixel(b.image, x, y, {1, 0, x == 12 ? std::nanf("") : 1, 1});
    ComparisonSettings settings = settings_with({region_of("10,10,10x10", 0)}, a);
    settings.flip.emplace();
    const Comparison c = compare(a, b, settings);
    BOOST_TEST(c.rmse == 0);
    BOOST_TEST(c.ssim == 1);
    BOOST_TEST(c.largest_difference == 0);
    BOOST_TEST(c.within_two == 1);
    BOOST_TEST(c.differing == 0);
    BOOST_TEST(c.flip->mean == 0);
    BOOST_TEST(c.not_finite.unequal == 0);
    BOOST_TEST(
        stored_pixel(difference_picture(a.image, b.image, 1, settings.weights.get()), 12, 12).r ==
        0);
    // With a region that is one row shorter, the pixels of that row count.
    const Comparison d = compare(a, b, settings_with({region_of("10,10,10x9", 0)}, a));
    BOOST_TEST(d.rmse > 0);
    BOOST_TEST(d.not_finite.unequal == 1);
    BOOST_TEST(d.differing == 10.0 / (1200 - 90), exactly);
}

BOOST_AUTO_TEST_CASE(weights_multiply_squares)
{
    // One of 100 pixels differs by 0.5 and has weight 3: 3 * 0.25 / (99 + 3).
    const Frame a = flat(10, 10, 0.5f);
    Frame b = a;
    store_pixel(b.image, 4, 5, {1, 1, 1, 1});
    const Comparison c = compare(a, b, settings_with({region_of("4,5,1x1", 3)}, a));
    BOOST_TEST(c.rmse == std::sqrt(0.75 / 102), exactly);
    BOOST_TEST(c.differing == 3.0 / 102, exactly);
    BOOST_TEST(c.largest_difference == 0.5, exactly);
}

BOOST_AUTO_TEST_CASE(lenses_are_regions)
{
    // 4 x 3 square lenses of 5 x 5 pixels, as in compare_pictures.cpp.
    Frame a = flat(20, 15, 0.5f);
    FrameMetadata m;
    m.sheet = {Arrangement::square, 1, 3, 1.5, 0, {0.5, 0}};
    m.film.pixel_pitch = {0.2, 0.2};
    m.aperture.distance = 300;
    set_metadata(a, m);
    Frame b = a;
    for (int x = 15; x < 20; ++x)
        store_pixel(b.image, x, 12, {0.7f, 0.7f, 0.7f, 1}); // lens 1,-1
    BOOST_TEST(compare(a, b, settings_with({region_of("lens:1,-1", 0)}, a)).rmse == 0);
    BOOST_TEST(compare(a, b, settings_with({region_of("lens:-2..1,-1..0", 0)}, a)).rmse == 0);
    const Comparison other = compare(a, b, settings_with({region_of("lens:0,-1", 0)}, a));
    BOOST_TEST(other.rmse > 0);
    BOOST_TEST(other.worst->lens.i == 1);
}

BOOST_AUTO_TEST_CASE(a_mask_weighs)
{
    const Frame a = flat(10, 10, 0.5f), b = flat(10, 10, 0.75f);
    Image mask = make_image<std::uint8_t>(10, 10, 3, {});
    store_pixel(mask, 3, 3, {1, 1, 1, 1});
    ComparisonSettings settings;
    settings.weights = std::make_shared<PixelWeights>(std::vector<Region>(), mask, 10, 10,
                                                      std::nullopt);
    Frame c = a;
    store_pixel(c.image, 3, 3, {0.6f, 0.5f, 0.5f, 1});
    BOOST_TEST(compare(a, b, settings).rmse == 0.25, exactly); // of the only pixel that counts
    BOOST_TEST(compare(a, c, settings).rmse == 0.1 / std::sqrt(3), exactly);
    BOOST_CHECK_THROW(PixelWeights({}, make_image<std::uint8_t>(10, 10, 3, {}), 10, 10, {}),
                      std::invalid_argument); // all black
    BOOST_CHECK_THROW(PixelWeights({}, mask, 10, 11, {}), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(what_is_no_region)
{
    for (const char* good :
         {"0,0,1x1", "10,20,300x400", "lens:0,0", "lens:-3..4,2", "lens:1,-2..-1"})
        BOOST_TEST(refusal_of(good) == "");
    for (const char* bad : {"", "1,2", "0,0,0x5", "-1,0,3x3", "0,0,1x1 ", "lens:", "lens:1",
                            "lens:4..3,0", "lens:0,0,0", "1.5,0,3x3", "lens:0..,1"})
        BOOST_TEST(refusal_of(bad) ==
                   "\"" + std::string(bad) +
                       "\" is no region; give X,Y,WxH in pixels, or lens:COLUMN,ROW, or ranges of "
                       "lenses as in lens:0..3,-2..2");
    BOOST_CHECK_THROW(PixelWeights({region_of("30,0,5x5", 0)}, {}, 30, 20, {}),
                      std::invalid_argument); // outside
    BOOST_CHECK_THROW(PixelWeights({region_of("0,0,30x20", 0)}, {}, 30, 20, {}),
                      std::invalid_argument); // everything
    BOOST_CHECK_THROW(PixelWeights({region_of("lens:0,0", 0)}, {}, 30, 20, {}),
                      std::invalid_argument); // no geometry
}

BOOST_AUTO_TEST_CASE(a_share_of_pixels_beyond_a_tolerance)
{
    const Frame a = flat(20, 10, 0.5f);
    Frame b = a;
    store_pixel(b.image, 2, 2, {0.5f, 0.55f, 0.5f, 1});
    store_pixel(b.image, 3, 2, {0.5f, 0.51f, 0.5f, 1});
    ComparisonSettings settings;
    settings.channel_tolerance = 0.02;
    BOOST_TEST(compare(a, b, settings).differing == 1.0 / 200, exactly);
    settings.channel_tolerance = 0;
    BOOST_TEST(compare(a, b, settings).differing == 2.0 / 200, exactly);
    Limits limits;
    limits[5] = 0.001;
    BOOST_TEST(missed_limits(limits, compare(a, b, settings)).at(0) ==
               "share of differing pixels 1% is greater than 0.1%");
    BOOST_TEST(*share_of("0.1%") == 0.001, exactly);
    BOOST_TEST(*share_of("0.25") == 0.25);
    for (const char* bad : {"", "%", "x", "1 %", "1%%"})
        BOOST_TEST(!share_of(bad));
}

BOOST_AUTO_TEST_CASE(regions_in_the_document)
{
    const Tolerances tolerances = tolerances_from_json(R"({
        "defaults": { "max_differing": "0.1%", "channel_tolerance": 0.02, "ignore": ["0,0,5x5"] },
        "files": { "glass/*": { "max_flip": 0.05, "ppd": 40, "weights": { "lens:0,0": 2 } },
                   "glass/ball.png": { "mask": "m.png", "ignore": ["1,1,2x2"] } } })");
    BOOST_TEST(*limits_for(tolerances, "a.png")[5] == 0.001, exactly);
    const ComparisonRules plain = rules_for(tolerances, "a.png"),
                          ball = rules_for(tolerances, "glass/ball.png");
    BOOST_TEST(!plain.flip);
    BOOST_TEST(plain.channel_tolerance == 0.02);
    BOOST_TEST(plain.regions.size() == 1);
    BOOST_TEST(ball.flip);
    BOOST_TEST(*ball.ppd == 40);
    BOOST_TEST(ball.mask == "m.png");
    BOOST_TEST(ball.regions.size() == 3);
    BOOST_TEST(ball.regions[1].weight == 2);
    BOOST_TEST(
        document_refusal("{\"defaults\": {\n\"ignore\": [\"0,0\"]}}") ==
        "line 2: \"0,0\" is no region; give X,Y,WxH in pixels, or lens:COLUMN,ROW, or ranges "
        "of lenses as in lens:0..3,-2..2");
    BOOST_TEST(document_refusal("{\"defaults\": {\"max_differing\": \"much\"}}") ==
               "line 1: \"max_differing\" must be a number from 0 to 1, or a share such as "
               "\"0.1%\", or null for no limit");
    BOOST_TEST(document_refusal("{\"defaults\": {\"weights\": {\"0,0,1x1\": -1}}}") ==
               "line 1: \"0,0,1x1\" must be a number from 0 to 1e+06");
    BOOST_TEST(document_refusal("{\"defaults\": {\"mask\": 1}}") ==
               "line 1: \"mask\" must be the path of a picture");
    BOOST_TEST(document_refusal("{\"defaults\": {\"ignore\": {}}}") ==
               "line 1: \"ignore\" must be a list of regions, [\"X,Y,WxH\", ...]");
}

BOOST_AUTO_TEST_SUITE_END()
