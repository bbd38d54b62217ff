// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests one real lens against the pinhole models: figure 3-26, and its beam from axis to margin.
#include "integral/sampling/lens_profile.h"

#include "integral/optics/aperture.h"
#include "integral/sheet/known_sheets.h"
#include "integral/sheet/sheet_figures.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>

using namespace integral;

BOOST_AUTO_TEST_SUITE(sampling_lens_profile)

namespace {

constexpr double degrees = 180 / 3.14159265358979323846;

LensSheet sheet(Arrangement arrangement = Arrangement::lenticular, double pitch = 1.27)
{
    LensSheet s;
    s.arrangement = arrangement;
    s.pitch = pitch;
    return s;
}

/// Angle to the axis of the ray from a film point (film, t) through the surface at v, by Snell's
/// law in the plane: written anew from the circle z = R - sqrt(R^2 - v^2), its normal and two
/// angles.
double angle_through(const LensSheet& s, double film, double v)
{
    const double radius = s.thickness * (s.ior - 1) / s.ior;
    const double z = radius - std::sqrt(radius * radius - v * v);
    const double normal = std::asin(v / radius);                 // of the surface, to the axis
    const double inside = std::atan2(v - film, s.thickness - z); // of the ray
    return normal + std::asin(s.ior * std::sin(inside - normal));
}

} // namespace

BOOST_AUTO_TEST_CASE(figure_3_26_half_intensity_is_equation_3_9)
{
    // Half of a cylinder lens's points image an edge farther out than the lens's pole does, and the
    // other half farther in.
    for (const double distance : {150.0, 300.0, 600.0, 1200.0}) {
        const double extended = micro_image_width(sheet(), distance, 195);
        const auto full = full_image_width(sheet(), distance, 195, 2001);
        BOOST_REQUIRE(full);
        BOOST_TEST(std::fabs(full->at_half / extended - 1) < 5e-4,
                   distance << ": " << full->at_half);
        BOOST_TEST(full->at_least < full->at_half);
        BOOST_TEST(full->at_most > full->at_half);
        // "A very rough explanation": the error of the straight pinhole is greater than the whole
        // blur.
        BOOST_TEST(pinhole_spread(sheet(), distance, 195) >
                   full->at_most + (full->at_most - full->at_least));
    }
    // For round lenses, this holds within 2%.
    const double extended = micro_image_width(sheet(), 300, 195);
    for (const Arrangement kind : {Arrangement::square, Arrangement::hexagonal})
        BOOST_TEST(std::fabs(full_image_width(sheet(kind), 300, 195, 64)->at_half / extended - 1) <
                   0.02);
}

BOOST_AUTO_TEST_CASE(figure_3_26_the_pinhole_is_n_1)
{
    LensSheet straight = sheet();
    straight.ior = 1;
    for (const double distance : {150.0, 300.0, 1200.0})
        BOOST_TEST(std::fabs(micro_image_width(straight, distance, 195) /
                                 pinhole_spread(sheet(), distance, 195) -
                             1) < 1e-14);
}

BOOST_AUTO_TEST_CASE(narrow_lenses_have_no_aberration)
{
    // The blur falls in proportion to the lens's width (curvature of the field), or faster (coma,
    // spherical aberration).
    double before = 0;
    for (const double pitch : {0.4, 0.2, 0.1, 0.05}) {
        const LensSheet narrow = sheet(Arrangement::square, pitch);
        const auto width = full_image_width(narrow, 300, 60, 40);
        const double extended = micro_image_width(narrow, 300, 60);
        const double blur = width->at_most - width->at_least;
        BOOST_TEST(std::fabs(width->at_half / extended - 1) < 0.02 * pitch);
        if (before > 0)
            BOOST_TEST(blur < 0.55 * before);
        before = blur;
    }
    BOOST_TEST(full_beam_direction(sheet(Arrangement::square, 1e-3), 0.3, 20)->error() < 1e-3);
}

BOOST_AUTO_TEST_CASE(image_width_agrees_with_tracing_forwards)
{
    // The share of the cell through which a film point sees the opening, ray by ray the other way.
    for (const Arrangement kind :
         {Arrangement::lenticular, Arrangement::square, Arrangement::hexagonal}) {
        const double distance = 300, width = 120;
        const SheetOptics optics(sheet(kind), {distance, width, 1, ApertureShape::rectangle},
                                 LensModel::full);
        constexpr int n = 60;
        const auto intensity = [&](double film) {
            int lit = 0, all = 0;
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < (kind == Arrangement::lenticular ? 1 : n); ++j, ++all) {
                    const double v = kind == Arrangement::lenticular ? 0.5 : (j + 0.5) / n;
                    const auto ray = beam_ray(optics, {film, 0}, {},
                                              cell_point(optics.lattice(), {(i + 0.5) / n, v}));
                    lit += ray && std::fabs(ray->aperture_point.x) <= 0.5 * width;
                }
            return double(lit) / all;
        };
        const auto measured = full_image_width(sheet(kind), distance, width, n);
        const double most = intensity(0);
        BOOST_TEST(most == 1);
        const double levels[][2] = {
            {measured->at_half, 0.5}, {measured->at_most, 0.1}, {measured->at_least, 0.9}};
        for (const auto& level : levels) {
            BOOST_TEST(intensity(0.5 * level[0] * 0.995) >= level[1] - 0.02,
                       int(kind) << " " << level[1]);
            BOOST_TEST(intensity(0.5 * level[0] * 1.005) <= level[1] + 0.02,
                       int(kind) << " " << level[1]);
        }
    }
}

BOOST_AUTO_TEST_CASE(beam_direction_by_snells_law)
{
    const LensSheet s = sheet();
    constexpr int n = 500;
    for (const double film : {0.0, 0.2, 0.5, 0.635}) {
        double mean = 0, squares = 0;
        const double pole = angle_through(s, film, 0);
        for (int i = 0; i < n; ++i) {
            const double error = (pole - angle_through(s, film, s.pitch * ((i + 0.5) / n - 0.5))) *
                                 degrees;
            mean += error / n;
            squares += error * error / n;
        }
        const auto beam = full_beam_direction(s, film, n);
        BOOST_REQUIRE(beam);
        BOOST_TEST(std::fabs(beam->pole + pole * degrees) < 1e-10);
        BOOST_TEST(std::fabs(beam->mean - mean) < 1e-10);
        BOOST_TEST(std::fabs(beam->error() - std::sqrt(squares)) < 1e-10);
        BOOST_TEST(beam->share == 1);
    }
    // The pole ray is (2-1) at the margin.
    BOOST_TEST(std::fabs(full_beam_direction(s, 0.635, 10)->pole - *greatest_angle(s)) < 1e-10);
}

BOOST_AUTO_TEST_CASE(beam_direction_is_symmetric)
{
    for (const LensSheet& s : thesis_sheets()) {
        BOOST_TEST(std::fabs(full_beam_direction(s, 0, 50)->mean) < 1e-9);
        for (const double part : {0.3, 0.8}) {
            const auto right = full_beam_direction(s, 0.5 * part * s.pitch, 50);
            const auto left = full_beam_direction(s, -0.5 * part * s.pitch, 50);
            BOOST_TEST(std::fabs(right->pole + left->pole) < 1e-9);
            BOOST_TEST(std::fabs(right->mean + left->mean) < 1e-9);
            BOOST_TEST(std::fabs(right->spread - left->spread) < 1e-9);
            BOOST_TEST(std::fabs(right->lower + left->upper) < 1e-9);
        }
    }
}

BOOST_AUTO_TEST_CASE(profiles_converge_with_the_number_of_rays)
{
    for (const Arrangement kind : {Arrangement::lenticular, Arrangement::square}) {
        const int many = kind == Arrangement::lenticular ? 8000 : 250;
        const auto direction = full_beam_direction(sheet(kind), 0.4, many);
        const auto width = full_image_width(sheet(kind), 300, 195, many);
        double before = std::numeric_limits<double>::infinity();
        for (const int points : {5, 20, 80}) {
            const auto beam = full_beam_direction(sheet(kind), 0.4, points);
            const double apart = std::hypot(beam->mean - direction->mean,
                                            beam->spread - direction->spread);
            BOOST_TEST(apart < 0.2 * before, points);
            before = apart;
            BOOST_TEST(std::fabs(full_image_width(sheet(kind), 300, 195, points)->at_half -
                                 width->at_half) < 0.3 / points);
        }
        BOOST_TEST(before < 3e-3);
    }
}

BOOST_AUTO_TEST_CASE(lenses_without_a_surface_have_no_profile)
{
    for (const double ior : {1.0, 1.05}) {
        LensSheet s = sheet();
        s.ior = ior;
        BOOST_CHECK(!full_image_width(s, 300, 195, 20));
        BOOST_CHECK(!full_beam_direction(s, 0.1, 20));
    }
    // totally reflected at the pole
    LensSheet thin = sheet();
    thin.thickness = 1.75;
    BOOST_CHECK(has_surface(thin));
    BOOST_CHECK(!full_beam_direction(thin, 1.75, 20));
}

BOOST_AUTO_TEST_CASE(appendix_e_pixels_per_lens_at_300_dpi)
{
    const double printed[] = {15, 7.087, 13.276, 9.980, 7.382};
    const auto sheets = thesis_sheets();
    BOOST_REQUIRE(sheets.size() == 5);
    for (int i = 0; i < 5; ++i) {
        BOOST_TEST(std::fabs(sheets[i].pitch * 300 / 25.4 - printed[i]) <= 0.0005);
        BOOST_TEST(has_surface(sheets[i]));
    }
}

BOOST_AUTO_TEST_SUITE_END()
