// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests which pixels anti-aliasing refines, and with how many samples.
#include "integral/reconstruction/refinement.h"
#include "tests/unit/pixel_origins.h"

#include <cstdlib>
#include <memory>
#include <random>

using namespace pixel_origins;

namespace {

constexpr int width = 120, height = 90;

/// A frame of 300 dpi behind lenses with a pitch of 15 pixels by default. colour(place behind the
/// lens in pitches, lens) gives a pixel's colour; if it returns nothing, the pixel is empty.
LightFieldImage coloured(Arrangement arrangement,
                         const std::function<std::optional<double>(Vec2, LensIndex)>& colour,
                         IntegralCamera* made = nullptr, double pitch = 1.27)
{
    CameraParameters p = parameters_of(arrangement);
    p.sheet.pitch = pitch;
    p.film.pixel_pitch = {25.4 / 300, 25.4 / 300};
    p.sheet.offset = 0.25 *
                     p.film.pixel_pitch; // with 15 pixels a lens, no pixel's middle is on a border
    p.mapping = LensMapping::closest;
    p.capture_aperture = Vec2{1e4, 1e4};
    const IntegralCamera camera = camera_of(p, width, height);
    LightFieldImage samples(camera);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Vec2 film_point = film_from_pixel(camera.film, {x + 0.5, y + 0.5});
            const auto ray = camera.optics.map(film_point, LensMapping::closest).ray;
            if (!ray)
                continue;
            const Vec2 pole = camera.optics.lattice().pole(ray->lens);
            Vec2 place = (1 / p.sheet.pitch) * (film_point - pole);
            if (arrangement == Arrangement::lenticular)
                place.y = film_point.y / p.sheet.pitch;
            if (const auto grey = colour(place, ray->lens))
                samples.set(x, y, {*grey, *grey, *grey, 0}, ray->lens, 0);
        }
    if (made)
        *made = camera;
    return samples;
}

double largest(const LightFieldImage& samples, int margin = 0)
{
    double most = -1;
    for (int y = margin; y < height - margin; ++y)
        for (int x = margin; x < width - margin; ++x)
            most = std::max(most, samples.contrast(x, y));
    return most;
}

} // namespace

BOOST_AUTO_TEST_SUITE(reconstruction_refinement)

BOOST_AUTO_TEST_CASE(even_colours_have_no_contrast)
{
    for (const Arrangement arrangement : arrangements)
        BOOST_TEST(largest(coloured(arrangement, [](Vec2, LensIndex) { return 0.7; })) == 0);
}

BOOST_AUTO_TEST_CASE(lens_borders_do_not_count)
{
    // Each lens has the same ramp from 0.1 to 0.9. Neighbours across a border differ by 0.8, but
    // each pixel can be predicted from its neighbours behind the same lens and in the same
    // direction. Pixels at the frame's edge are left out, because they lack neighbours on one side.
    for (const Arrangement arrangement : arrangements)
        for (const double pitch : {1.27, 1.124, 0.845}) {
            const auto ramp = [](Vec2 place, LensIndex) { return 0.5 + 0.8 * place.x; };
            BOOST_TEST(largest(coloured(arrangement, ramp, nullptr, pitch), 20) <
                           3 * 2 * 0.8 * (25.4 / 300) / pitch,
                       int(arrangement) << " " << pitch);
        }
}

BOOST_AUTO_TEST_CASE(neighbours_of_either_kind_count)
{
    const auto is_between = [](const LightFieldImage& samples, double low, double high) {
        for (int y = 20; y < height - 20; ++y)
            for (int x = 20; x < width - 20; ++x)
                BOOST_TEST_REQUIRE(
                    (samples.contrast(x, y) >= low && samples.contrast(x, y) <= high),
                    x << ", " << y);
    };
    for (const Arrangement arrangement : arrangements) {
        // every other lens: a double step of 3 times 0.4 between a lens and both of its neighbours
        const auto lenses = [](Vec2, LensIndex lens) { return lens.i & 1 ? 0.6 : 0.2; };
        is_between(coloured(arrangement, lenses), 2.3, 2.5);
    }
    // one odd lens, pixel or row among others
    for (const Arrangement arrangement : arrangements) {
        IntegralCamera camera = camera_of(parameters_of(arrangement));
        const auto odd_lens = [](Vec2, LensIndex lens) {
            return lens == LensIndex{1, 0} ? 1.0 : 0.5;
        };
        const auto one = coloured(arrangement, odd_lens, &camera);
        for (int y = 20; y < height - 20; ++y)
            for (int x = 20; x < width - 20; ++x) {
                const Vec2 at = film_from_pixel(camera.film, {x + 0.5, y + 0.5});
                const auto lens = camera.optics.map(at, LensMapping::closest).ray->lens;
                if (lens == LensIndex{1, 0})
                    BOOST_TEST((one.contrast(x, y) > 2.9 && one.contrast(x, y) < 3.1));
                else
                    BOOST_TEST(
                        (one.contrast(x, y) < 0.01 || std::fabs(one.contrast(x, y) - 1.5) < 0.01));
            }
    }
    // An edge behind each lens: only the two pixels next to it deviate from a straight line.
    const auto edge = coloured(Arrangement::square,
                               [](Vec2 place, LensIndex) { return place.x < 0.03 ? 0.0 : 1.0; });
    int beside = 0;
    for (int x = 20; x < width - 20; ++x)
        beside += edge.contrast(x, 45) > 2.9;
    BOOST_TEST(beside >= 2 * 4);
    BOOST_TEST(beside <= 2 * 7);
}

BOOST_AUTO_TEST_CASE(empty_pixels_are_nobody_s_neighbours)
{
    // Only the middle of each lens is lit, as behind a narrow aperture; its colour is even.
    const auto middle = [](Vec2 place, LensIndex) {
        return std::fabs(place.x) < 0.3 ? std::optional<double>(0.9) : std::nullopt;
    };
    for (const Arrangement arrangement : arrangements) {
        const LightFieldImage samples = coloured(arrangement, middle);
        BOOST_TEST(largest(samples) == 0);
        int empty = 0;
        for (int x = 0; x < width; ++x)
            empty += samples.contrast(x, 45) == -1;
        BOOST_TEST(empty > width / 4);
    }
    // a pixel without a neighbour
    const LightFieldImage alone = coloured(Arrangement::square, [](Vec2 place, LensIndex lens) {
        const bool lit = lens == LensIndex{0, 0} && std::fabs(place.x) < 0.02 &&
                         std::fabs(place.y) < 0.02;
        return lit ? std::optional<double>(0.5) : std::nullopt;
    });
    BOOST_TEST(std::isinf(largest(alone)));
}

BOOST_AUTO_TEST_CASE(hostile_colours_are_kept_in_range)
{
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();
    for (const double hostile : {nan, infinity, -infinity, 1e300, -1.0}) {
        const auto every_other = [&](Vec2, LensIndex lens) { return lens.i & 1 ? hostile : 0.5; };
        const LightFieldImage samples = coloured(Arrangement::square, every_other);
        BOOST_TEST(std::isfinite(largest(samples)));
        BOOST_TEST(largest(samples) >= 1);
    }
}

BOOST_AUTO_TEST_CASE(method_1_takes_all_samples_at_once)
{
    for (const int depth : {1, 3, 9}) {
        RefinementRule rule{1, 0.3, depth};
        Refinement refinement(rule, 1);
        BOOST_TEST(refinement.requested() == depth * depth);
        for (int k = 0; k < depth * depth; ++k)
            k % 2 ? refinement.add({0.5, 0.5, 0.5, 0}) : refinement.add_none();
        BOOST_TEST(refinement.requested() == 0);
    }
}

BOOST_AUTO_TEST_CASE(first_samples_may_be_kept_in_memory_from_outside)
{
    CameraParameters p = parameters_of(Arrangement::square);
    const IntegralCamera camera = camera_of(p, width, height);
    const std::size_t bytes = LightFieldImage::bytes(camera.film);
    BOOST_TEST(bytes == 16u * width * height);
    const std::shared_ptr<void> memory(std::calloc(bytes, 1), std::free);
    LightFieldImage samples(camera, memory);
    BOOST_TEST(std::isnan(samples.depth(3, 4)));
    BOOST_TEST(samples.contrast(3, 4) == -1);
    samples.set(3, 4, {0, 0, 0, 0}, {0, 0}, 0); // all bytes zero
    const LightFieldImage& there = LightFieldImage(camera, memory);
    BOOST_TEST(there.depth(3, 4) == 0);
    BOOST_TEST(!std::signbit(there.depth(3, 4)));
    BOOST_TEST(std::isinf(there.contrast(3, 4)));
    BOOST_TEST(there.contrast(4, 4) == -1);
}

BOOST_AUTO_TEST_CASE(samples_show_a_contrast)
{
    // Half of the samples are black, half are white: their standard deviation is 0.5. At an edge
    // the standard deviation of samples is 0.4 of the edge's contrast on average.
    const RefinementRule rule{2, 0.1, 4};
    Refinement halves(rule, 0), even(rule, 0);
    for (int k = 0; k < 8; ++k) {
        const double grey = k % 2;
        halves.add({grey, grey, grey, 0});
        even.add({0.5, 0.5, 0.5, 0});
    }
    BOOST_TEST(std::abs(halves.contrast_shown() - 3 * 0.5 / 0.4) < 1e-12);
    BOOST_TEST(even.contrast_shown() == 0);
}

BOOST_AUTO_TEST_CASE(method_2_goes_on_while_samples_are_worth_it)
{
    double before_last = 0,
           last = 0; // a sample's benefit after all rounds but the last, and after all
    const auto samples_taken = [&](const RefinementRule& rule, double contrast, auto next) {
        Refinement refinement(rule, contrast);
        int taken = 0;
        while (const int requested = refinement.requested()) {
            BOOST_TEST(requested == (taken == 0 ? 4 : taken)); // 4, 8, 16, ... in all
            before_last = refinement.marginal_benefit();
            for (int k = 0; k < requested; ++k, ++taken)
                refinement.add(next());
        }
        last = refinement.marginal_benefit();
        return taken;
    };
    std::mt19937 random(1);
    const auto even = [] { return ComparedColour{0.4, 0.4, 0.4, 0}; };
    const auto coin = [&] {
        const double grey = random() & 1;
        return ComparedColour{grey, grey, grey, 0};
    };
    BOOST_TEST(samples_taken({2, 0.1, 4}, 0.1, even) == 4);
    BOOST_TEST(samples_taken({2, 0.01, 4}, 3, even) > 4); // contrast that the first 4 did not hit
    int before = 0;
    for (const double threshold : {1.0, 0.3, 0.1, 0.03}) {
        const int taken = samples_taken({2, threshold, 9}, 3, coin);
        BOOST_TEST(taken > before);
        BOOST_TEST(last <= threshold);
        BOOST_TEST(last > 0);
        BOOST_TEST(before_last > threshold / 4); // still large with half as many
        before = taken;
    }
    BOOST_TEST(samples_taken({2, 0, 3}, 3, coin) == 64);
    RefinementRule rule{2, 0.3, 3};
    Refinement none(rule, 3);
    int tried = 0;
    for (; none.requested(); ++tried)
        none.add_none();
    BOOST_TEST(tried == 64);
    BOOST_TEST(std::isinf(none.marginal_benefit()));
}

BOOST_AUTO_TEST_CASE(further_samples_are_taken_as_long_as_one_is_worth_it)
{
    const RefinementRule rule{2, 0.1, 3, true};
    const auto further = [&](int tried, double squared_error, double part, double of_many = 0) {
        return further_samples(rule, {tried, tried}, squared_error, part, of_many);
    };
    BOOST_TEST(further(1, 0.1, 1) == 3);
    BOOST_TEST(further(4, 0.1, 1) == 4);
    BOOST_TEST(further(32, 0.1, 1) == 32);
    BOOST_TEST(further(64, 0.1, 1) == 0); // 4^depth
    BOOST_TEST(further(4, 0.1, 0) == 0);
    BOOST_TEST(further(4, 0, 1) == 0);
    BOOST_TEST(further_samples({1, 0.1, 3, true}, {4, 4}, 0.1, 1, 0) == 0);
    // The benefit depends on the part times the root of (squared error / number of samples).
    double least = 1;
    while (further(4, least, 1))
        least *= 0.9;
    BOOST_TEST(further(16, 3.6 * least, 1) == 0);
    BOOST_TEST(further(16, 4.5 * least, 1) == 16);
    BOOST_TEST(further(4, 3.6 * least, 0.5) == 0);
    BOOST_TEST(further(4, 4.5 * least, 0.5) == 4);
    // Extra samples need a larger benefit where many pixels take them.
    BOOST_TEST(further(4, 4 * least, 1, 0.5) == 4);
    BOOST_TEST(further(4, 4 * least, 1, 1) == 0);
    BOOST_TEST(further_samples({2, 0.05, 3, true}, {4, 4}, least, 1, 0) == 4);

    BOOST_TEST(squared_error_falls(4, 0) == 1);
    BOOST_TEST(squared_error_falls(4, 4) > 0.25); // between an even grid and random samples
    BOOST_TEST(squared_error_falls(4, 4) < 0.5);
}

BOOST_AUTO_TEST_SUITE_END()
