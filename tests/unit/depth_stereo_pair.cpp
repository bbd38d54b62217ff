// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the depth of stereo pairs on two textured planes, and pictures and maps that are reduced.
#include "integral/depth/averaged.h"
#include "integral/depth/relief.h"
#include "integral/depth/stereo_pair.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstdint>
#include <set>

using namespace integral;

BOOST_AUTO_TEST_SUITE(depth_stereo_pair)

namespace {

constexpr int width = 160, height = 60;
constexpr int far = -3, near = 9;                            // disparities, pixels
constexpr int first = 60, last = 100, top = 15, bottom = 45; // the card in the left picture

/// A random colour of a texture's pixel.
Colour paint(int texture, int x, int y)
{
    std::uint32_t bits = std::uint32_t(texture * 7919 + y * 104729 + (x + 1000) * 1299709);
    for (int k = 0; k < 3; ++k)
        bits = (bits ^ (bits >> 15)) * 0x2c1b3c6du + 12345;
    const auto part = [&](int shift) { return float(bits >> shift & 255) / 255; };
    return {part(0), part(8), part(16), 1};
}

bool on_card(int x, int y) { return x >= first && x < last && y >= top && y < bottom; }

/// The left (-1) or the right (1) picture: a point of the left one stands as many pixels as its
/// disparity farther to the left in the right one.
Image picture(int side)
{
    Image made = make_image<std::uint8_t>(width, height, 3, Encoding());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int card = x + (side > 0 ? near : 0), wall = x + (side > 0 ? far : 0);
            store_pixel(made, x, y, on_card(card, y) ? paint(1, card, y) : paint(2, wall, y));
        }
    return made;
}

float at(const std::vector<float>& map, int x, int y)
{
    return map[std::size_t(y) * width + std::size_t(x)];
}

} // namespace

BOOST_AUTO_TEST_CASE(two_planes)
{
    const PairDisparity pair = pair_disparity(picture(-1), picture(1), 1, {});
    BOOST_TEST(pair.width == width);
    BOOST_TEST(std::fabs(pair.range.least - far) < 0.2);
    BOOST_TEST(std::fabs(pair.range.greatest - near) < 0.2);
    BOOST_TEST(pair.matched > 0.75);
    int wrong = 0, all = 0;
    for (int y = top + 6; y < bottom - 6; ++y)
        for (int x = 0; x < width; ++x) {
            if (std::abs(x - first) < 4 || std::abs(x - last) < 4)
                continue; // edges are found to a few pixels
            ++all;
            wrong += std::fabs(at(pair.left, x, y) - (on_card(x, y) ? near : far)) > 0.3;
        }
    BOOST_TEST(wrong < 0.01 * all, wrong << " of " << all);
}

BOOST_AUTO_TEST_CASE(what_the_other_picture_hides_is_the_wall)
{
    // Twelve pixels of the wall to the left of the card are behind it in the right picture, and
    // twelve to its right in the right picture are in the left one.
    const PairDisparity pair = pair_disparity(picture(-1), picture(1), 1, {});
    for (int y = top + 6; y < bottom - 6; ++y)
        for (int k = 4; k < 12; ++k) {
            BOOST_TEST(std::fabs(at(pair.left, first - k, y) - far) < 0.3);
            BOOST_TEST(std::fabs(at(pair.right, last - near + k, y) - far) < 0.3);
        }
}

BOOST_AUTO_TEST_CASE(reduced_pictures)
{
    Image picture = make_image<float>(7, 4, 3, {Encoding::Kind::linear, 1});
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 7; ++x)
            store_pixel(picture, x, y, {float(x), float(y), 0, 1});
    BOOST_TEST(reduction(picture, 3) == 2);
    BOOST_TEST(reduction(picture, 4) == 1);
    BOOST_TEST(reduction(picture, 1) == 4); // at most the height
    const Image mean = averaged(picture, 2, 1);
    BOOST_TEST(mean.width == 3);
    BOOST_TEST(mean.height == 2);
    BOOST_TEST(stored_pixel(mean, 1, 1).r == 2.5f);
    BOOST_TEST(stored_pixel(mean, 1, 1).g == 2.5f);
}

// A slope of 60 x 40 pixels, 0.1 mm each, whose parallax is 0.2 + 0.03 times the place across, mm.
BOOST_AUTO_TEST_CASE(maps_are_thinned_to_the_spacing_of_lines)
{
    constexpr int across = 60, down = 40;
    constexpr double pixel = 0.1;
    const PixelPlaces places{{-2.95, 1.95}, {pixel, 0}, {0, -pixel}};
    const auto slope = [](double x) { return 0.2 + 0.03 * x; };
    ReliefPicture picture{{0, 0}, across, down, places, {}, {}};
    ReliefMap map{{0, 0}, across, down, places, {}, 0};
    for (auto& channel : picture.light)
        channel.assign(across * down, 0.5f);
    for (int k = 0; k < across * down; ++k)
        map.parallax.push_back(float(slope(places.at(k % across, 0).x)));
    const struct {
        Vec2 spacing;
        std::size_t kept; // of the map's columns
        double nearest;   // mm, from any place to that of a kept column
    } cases[] = {{{0.19, 0.19}, 60, 0.01},
                 {{0.2, 0.1}, 30, 0.11},
                 {{0.75, 0.3}, 9, 0.36},
                 {{90, 90}, 1, 3.06}};
    for (const auto& one : cases) {
        Relief relief({picture}, {map}, 400, {6, 4});
        relief.thin(one.spacing);
        std::set<float> depths;
        for (int k = 0; k < across; ++k) {
            const Vec2 place = places.at(k, 7);
            const double seen = relief.along({place, {0, 0}}).parallax;
            BOOST_TEST(std::fabs(seen - slope(place.x)) <= 0.03 * one.nearest);
            depths.insert(float(seen));
        }
        BOOST_TEST(depths.size() == one.kept);
    }
    // A turned view's map, whose rows go up: its columns are thinned as far as lines are apart
    // down.
    map.places = picture.places = {{-1.95, -2.95}, {0, pixel}, {pixel, 0}};
    Relief turned({picture}, {map}, 400, {4, 6});
    turned.thin({0.75, 0.19});
    std::set<float> depths;
    for (int k = 0; k < across; ++k)
        depths.insert(float(turned.along({map.places.at(k, 7), {0, 0}}).parallax));
    BOOST_TEST(depths.size() == across);
}

BOOST_AUTO_TEST_SUITE_END()
