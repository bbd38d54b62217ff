// SPDX-License-Identifier: AGPL-3.0-or-later
// Masks and height maps: their greys against closed forms, and the calibration loop.
#include "integral/laboratory/mask_picture.h"

#include "integral/base/constants.h"

#include <boost/test/unit_test.hpp>

#include <stdexcept>

using namespace integral;

namespace {

MaskRequest request_of(Arrangement arrangement)
{
    MaskRequest request;
    request.sheet.arrangement = arrangement;
    request.shape = focused_shape(request.sheet, 0);
    request.film = {60, 60, {0.0635, 0.0635}}; // a pitch is 20 pixels
    return request;
}

double grey_at(const Image& image, int x, int y) { return stored_pixel(image, x, y).r; }

/// A process whose response is steep in the middle.
Response steep_process()
{
    std::vector<Response::Sample> samples;
    for (int k = 0; k <= 100; ++k)
        samples.push_back({0.01 * k, 0.2 / (1 + std::exp(-0.15 * (k - 40)))});
    return Response(samples);
}

} // namespace

BOOST_AUTO_TEST_SUITE(laboratory_fabrication)

BOOST_AUTO_TEST_CASE(greys_are_the_lens_and_repeat_with_the_pitch)
{
    const Image image = *mask_picture(request_of(Arrangement::lenticular), 1, {});
    const double radius = 3.08 * 0.6 / 1.6, half = 0.635;
    const auto sag = [&](double x) { return radius - std::sqrt(radius * radius - x * x); };
    for (int x = 0; x < 60; ++x) {
        const double from_axis = std::remainder((x + 0.5 - 30) * 0.0635, 1.27);
        BOOST_TEST(std::fabs(grey_at(image, x, 7) - sag(from_axis) / sag(half)) < 1e-5);
        BOOST_TEST(grey_at(image, x, 7) == grey_at(image, x, 50));
    }
    auto relief = request_of(Arrangement::square);
    relief.kind = MaskKind::relief;
    const Image heights = *mask_picture(relief, 1, {});
    for (int x = 0; x < 40; ++x)
        BOOST_TEST(std::fabs(grey_at(heights, x, 3) - grey_at(heights, x + 20, 23)) < 2.0 / 65535);
    BOOST_TEST(grey_at(heights, 30, 30) > 0.99);
    relief.negative = true;
    BOOST_TEST(std::fabs(1 - grey_at(heights, 9, 4) - grey_at(*mask_picture(relief, 1, {}), 9, 4)) <
               2.0 / 65535);
}

BOOST_AUTO_TEST_CASE(a_mask_of_one_lens_is_the_size_of_its_cell)
{
    for (const Arrangement arrangement :
         {Arrangement::lenticular, Arrangement::square, Arrangement::hexagonal}) {
        MaskRequest request = request_of(arrangement);
        request.sheet.offset = {0.3, 0.2};
        request.sheet.slant = 12;
        request.film.width = 64;
        request.film.height = 48;
        show_one_lens(request);
        // A hexagon is as wide as the pitch from side to side, and longer from corner to corner.
        const double height = arrangement == Arrangement::hexagonal ? 1.27 * 2 / std::sqrt(3.0)
                                                                    : 1.27;
        BOOST_TEST(std::fabs(64 * request.film.pixel_pitch.x - 1.27) < 1e-12);
        BOOST_TEST(std::fabs(48 * request.film.pixel_pitch.y - height) < 1e-12);
        BOOST_TEST((request.sheet.offset.x == 0 && request.sheet.offset.y == 0));
        BOOST_TEST(request.sheet.slant == 0);
    }
}

BOOST_AUTO_TEST_CASE(the_process_sculpts_the_lens_from_its_mask)
{
    auto request = request_of(Arrangement::hexagonal);
    request.shape = focused_shape(request.sheet, focusing_conic(request.sheet));
    const Response process = steep_process();
    request.response = process;
    request.from_depth = 0.01;
    BOOST_CHECK_THROW(MaskGrey{request}, std::invalid_argument); // too deep for the process
    request.sheet.pitch = 0.6;
    const MaskGrey mask(request);
    for (int k = 0; k < 200; ++k) {
        const Vec2 point{0.013 * k, 0.7 - 0.011 * k};
        const double sculpted = process.depth(mask.at(point)) - 0.01;
        BOOST_TEST(std::fabs(sculpted - mask.relief().depth(point)) < 1e-12);
    }
}

BOOST_AUTO_TEST_CASE(calibration_ends_at_the_grey_levels)
{
    const Response process = steep_process();
    double last = 0;
    for (const int levels : {256, 65536}) {
        const Calibration found = calibrate(process, levels);
        BOOST_REQUIRE(found.rounds.size() >= 3u);
        // A straight line is far off at first; half of the steepest step is left.
        const double step = 0.15 * 100 / 4 * 0.2 / (levels - 1);
        BOOST_TEST(found.rounds.front().greatest > 0.05);
        BOOST_TEST(found.rounds.back().greatest < 0.75 * step);
        last = found.rounds.back().rms;
        for (double depth = 0.01; depth < 0.19; depth += 0.01)
            BOOST_TEST(std::fabs(found.found.grey(depth) - process.grey(depth)) <
                       1.0 / (levels - 1) + 1e-4);
    }
    BOOST_TEST(last < 1e-5);
}

BOOST_AUTO_TEST_CASE(a_turn_of_the_spinning_shape_is_the_mask)
{
    auto request = request_of(Arrangement::square);
    const MaskGrey mask(request);
    auto spinning = request;
    spinning.kind = MaskKind::spinning;
    const MaskGrey shape(spinning);
    for (const double r : {0.05, 0.2, 0.4, 0.63}) {
        double mean = 0;
        constexpr int places = 20000;
        for (int k = 0; k < places; ++k) {
            const double angle = 2 * pi * (k + 0.5) / places;
            mean += shape.at({r * std::cos(angle), r * std::sin(angle)}) / places;
        }
        BOOST_TEST(std::fabs(mean - mask.at({r, 0})) < 1e-4);
    }
    BOOST_TEST(shape.at({0.95, 0}) == 0);
}

BOOST_AUTO_TEST_CASE(greys_lie_from_0_to_1)
{
    BOOST_CHECK_NO_THROW(Response({{0, 0}, {1, 2}}));
    BOOST_CHECK_THROW(Response({{-0.1, 0}, {1, 2}}), std::invalid_argument);
    BOOST_CHECK_THROW(Response({{0, 0}, {1.1, 2}}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
