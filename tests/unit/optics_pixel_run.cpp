// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests that pixels mapped in runs equal pixels mapped one by one, bit for bit, and that most
// pixels of a frame are mapped in runs.
#include "integral/lightfield/pixel_sampler.h"
#include "integral/optics/pixel_run.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstring>
#include <limits>
#include <random>
#include <string>

using namespace integral;

namespace {

bool same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }
bool same(Vec3 a, Vec3 b) { return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z); }

struct Found {
    long imaged = 0, given = 0, searched = 0, not_imaged = 0, empty = 0;
};

/// All runs of a frame, from every pixel on, against one_ray and sight_line.
Found compare(const CameraParameters& parameters, const ViewFrame& view, int width, int height,
              const std::string& what)
{
    const IntegralCamera camera = make_camera(parameters, view, width, height);
    const PixelSampler sampler(camera, 1);
    const PixelRuns runs(camera);
    Found found;
    BOOST_REQUIRE_MESSAGE(runs.possible() && sampler.gives_one_ray(), what);
    PixelRun run;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; x += PixelRun::pixels - 1) {
            runs.work_out({x + 0.5, y + 0.5}, run);
            for (int k = 0; k < PixelRun::pixels; ++k) {
                PixelOutcome outcome;
                const auto ray = sampler.one_ray({x + k + 0.5, y + 0.5}, outcome);
                found.imaged += outcome.imaged;
                found.not_imaged += outcome.outside_aperture + outcome.total_reflection;
                found.given += run.given[k];
                if (run.empty[k]) {
                    BOOST_REQUIRE_MESSAGE(!run.given[k] && !ray && outcome.outside_aperture == 1,
                                          what << ": pixel " << x + k << ", " << y
                                               << " is not empty");
                    ++found.empty;
                }
                if (!run.given[k])
                    continue;
                BOOST_REQUIRE_MESSAGE(
                    ray && outcome.searched == int(run.searched[k]),
                    what << ": pixel " << x + k << ", " << y
                         << (ray ? " has been searched for otherwise" : " images nothing"));
                found.searched += run.searched[k];
                const SightLine line = sight_line(camera, *ray);
                BOOST_REQUIRE_MESSAGE(outcome.lens == run.lens[k], what << ": pixel " << x + k
                                                                        << ", " << y
                                                                        << " has another lens");
                BOOST_REQUIRE_MESSAGE(same(line.origin, run.line[k].origin) &&
                                          same(line.direction, run.line[k].direction) &&
                                          same(line.length, run.line[k].length),
                                      what << ": pixel " << x + k << ", " << y
                                           << " has another line");
            }
        }
    return found;
}

ViewFrame view_of(int width, int height, double pitch, double distance)
{
    return {
        {0.3, 2, -distance}, {0, 0, distance}, {width * pitch, 0, 0}, {0, height * pitch, 0}, 1};
}

} // namespace

BOOST_AUTO_TEST_SUITE(optics_pixel_run)

BOOST_AUTO_TEST_CASE(a_run_is_its_pixels)
{
    constexpr int width = 150, height = 100;
    constexpr double pitch = mm_per_inch / 300;
    for (const auto arrangement : {Arrangement::lenticular, Arrangement::square})
        for (const double slant : {0.0, 9.46, -30.0, 45.0, 60.0, -89.0})
            for (const bool limited : {false, true}) {
                CameraParameters parameters;
                const bool lenticular = arrangement == Arrangement::lenticular;
                parameters.sheet = {arrangement,
                                    lenticular ? 1.27 : 1.124,
                                    lenticular ? 3.08 : 3.23,
                                    lenticular ? 1.6 : 1.675,
                                    slant,
                                    {0.1, -0.2}};
                if (limited)
                    parameters.depth_range = Vec2{40, 90};
                parameters.mapping = limited ? LensMapping::closest : LensMapping::automatic;
                const std::string what = (lenticular ? "lenticular, " : "square, ") +
                                         std::to_string(slant) +
                                         (limited ? " degrees, limited" : " degrees");
                const Found found = compare(parameters, view_of(width, height, pitch, 350), width,
                                            height, what);
                BOOST_TEST(found.given >= 0.94 * found.imaged,
                           what << ": only " << found.given << " of " << found.imaged);
                if (limited) // `closest`
                    BOOST_TEST(found.empty >= 0.99 * found.not_imaged,
                               what << ": only " << found.empty << " of " << found.not_imaged
                                    << " empty");
            }
}

BOOST_AUTO_TEST_CASE(searched_for)
{
    // A sheet as broad as the eye is far: at its sides many pixels are another lens's than the
    // nearest.
    constexpr int width = 240, height = 40;
    constexpr double pitch = 10 * mm_per_inch / 300;
    for (const auto arrangement : {Arrangement::lenticular, Arrangement::square})
        for (const double slant : {0.0, 9.46, 45.0})
            for (const auto mapping : {LensMapping::closest, LensMapping::automatic}) {
                CameraParameters parameters;
                parameters.sheet = {arrangement, 1.27, 3.08, 1.6, slant, {0.1, -0.2}};
                parameters.film.pixel_pitch = {pitch, pitch};
                parameters.mapping = mapping;
                // Of the size that fills an upright lens: behind a leaning one's default, which is
                // wider, the nearest lens serves nearly every pixel.
                const double filling = *filling_width(parameters.sheet, 200,
                                                      parameters.sheet.pitch);
                if (arrangement == Arrangement::square)
                    parameters.capture_aperture = Vec2{filling, filling};
                const std::string what = std::to_string(int(arrangement)) + ", " +
                                         std::to_string(slant) + " degrees";
                const Found found = compare(parameters, view_of(width, height, pitch, 200), width,
                                            height, what);
                if (mapping == LensMapping::closest)
                    BOOST_TEST(found.searched == 0);
                else {
                    BOOST_TEST(found.searched >= 0.09 * found.imaged, what << ": " << found.searched
                                                                           << " searched for, of "
                                                                           << found.imaged);
                    BOOST_TEST(found.given >= 0.93 * found.imaged,
                               what << ": only " << found.given << " of " << found.imaged);
                    BOOST_TEST(found.empty > (slant == 45 ? 0.05 : 0.3) * found.not_imaged,
                               what << ": only " << found.empty << " of " << found.not_imaged
                                    << " empty");
                }
            }
}

BOOST_AUTO_TEST_CASE(any_camera)
{
    // Thin and thick sheets, near and far eyes, coarse and fine films, wide and narrow apertures,
    // skewed views.
    std::mt19937 random(7);
    const auto between = [&](double low, double high) {
        return low * std::pow(high / low, std::uniform_real_distribution<double>(0, 1)(random));
    };
    const auto even = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    long given = 0, imaged = 0, empty = 0, cameras = 0;
    for (int trial = 0; trial < 400; ++trial) {
        CameraParameters parameters;
        const double pitch = between(0.05, 20);
        parameters.sheet = {trial & 1 ? Arrangement::lenticular : Arrangement::square,
                            pitch,
                            pitch * between(0.5, 8),
                            even(1.01, 2.5),
                            even(-89, 89),
                            {even(-pitch, pitch), even(-pitch, pitch)}};
        const double pixel = pitch / between(2, 40), distance = pitch * between(3, 3000);
        parameters.film.pixel_pitch = {pixel, pixel * between(0.5, 2)};
        parameters.capture_aperture = Vec2{distance * between(0.01, 3),
                                           distance * between(0.01, 3)};
        parameters.beam_samples = 1; // a slit that has a height, too
        if (trial % 3 == 0)
            parameters.depth_range = Vec2{distance * even(0, 1.5), distance * even(0, 3)};
        constexpr int width = 60, height = 20;
        ViewFrame view = view_of(width, height, pixel, distance);
        const double turn = even(-3, 3);
        view.direction = {distance * std::sin(turn), 0, distance * std::cos(turn)};
        view.right = {width * pixel * std::cos(turn), 0, -width * pixel * std::sin(turn)};
        Found found;
        try {
            found = compare(parameters, view, width, height, "camera " + std::to_string(trial));
        } catch (const std::invalid_argument&) { // cannot be
            continue;
        }
        given += found.given;
        imaged += found.imaged;
        empty += found.empty;
        ++cameras;
    }
    BOOST_TEST(cameras > 200);
    BOOST_TEST(given > 0.8 * imaged);
    BOOST_TEST(empty > 1000);
    BOOST_TEST_MESSAGE(given << " of " << imaged << " pixels, and " << empty << " empty, of "
                             << cameras << " cameras");
}

BOOST_AUTO_TEST_CASE(where_there_are_none)
{
    CameraParameters parameters;
    parameters.sheet = {Arrangement::square, 1.124, 3.23, 1.675, 0, {}};
    const auto possible = [&](auto change) {
        CameraParameters changed = parameters;
        change(changed);
        return PixelRuns(make_camera(changed, view_of(150, 100, 0.1, 350), 150, 100)).possible();
    };
    BOOST_TEST(possible([](CameraParameters&) {}));
    BOOST_TEST(
        !possible([](CameraParameters& p) { p.sheet.arrangement = Arrangement::hexagonal; }));
    BOOST_TEST(!possible([](CameraParameters& p) { p.mapping = LensMapping::accurate; }));
    BOOST_TEST(!possible([](CameraParameters& p) { p.mapping = LensMapping::exhaustive; }));
    BOOST_TEST(!possible([](CameraParameters& p) { p.aperture_shape = ApertureShape::ellipse; }));
    BOOST_TEST(!possible([](CameraParameters& p) { p.model = LensModel::full; }));
    BOOST_TEST(!possible([](CameraParameters& p) { p.model = LensModel::pinhole; }));
    BOOST_TEST(!possible([](CameraParameters& p) { p.pseudoscopic = true; }));
}

BOOST_AUTO_TEST_SUITE_END()
