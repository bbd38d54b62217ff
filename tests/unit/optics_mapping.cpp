// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the mappings from film points to lenses: accurate equals exhaustive, closest is part of
// auto, and symmetries.
#include "integral/optics/coverage.h"
#include "tests/unit/optics_sheets.h"

#include <boost/test/unit_test.hpp>

using namespace integral;

namespace {

/// A sheet and an aperture that underfills or overfills the lenses, few enough for a search of all.
struct System {
    LensSheet sheet;
    Aperture aperture;
};

System random_system(random_sheets::Generator& random)
{
    System s;
    s.sheet = random.sheet();
    s.sheet.thickness = s.sheet.pitch * random.log_between(0.3, 20);
    const double distance = s.sheet.pitch * random.log_between(0.5, 3000);
    const auto fill = filling_aperture(s.sheet, distance);
    s.aperture = fill ? *fill : Aperture{distance, distance, distance};
    const double wider = random.log_between(0.3, 5);
    s.aperture.width *= wider;
    s.aperture.height *= wider;
    s.aperture.shape = random.one_in(3) ? ApertureShape::ellipse : ApertureShape::rectangle;
    return s;
}

bool same(const MappedPoint& a, const MappedPoint& b)
{
    return a.ray.has_value() == b.ray.has_value() && (!a.ray || a.ray->lens == b.ray->lens);
}

} // namespace

BOOST_AUTO_TEST_SUITE(optics_mapping)

BOOST_AUTO_TEST_CASE(accurate_equals_exhaustive)
{
    random_sheets::Generator random(77);
    const int systems = random_sheets::count(6000, 300000);
    int imaged = 0;
    for (int k = 0; k < systems; ++k) {
        const System s = random_system(random);
        const SheetOptics optics(s.sheet, s.aperture);
        for (int i = 0; i < 20; ++i) {
            const Vec2 point{random.between(-40, 40) * s.sheet.pitch,
                             random.between(-40, 40) * s.sheet.pitch};
            const MappedPoint accurate = optics.map(point, LensMapping::accurate);
            imaged += accurate.ray.has_value();
            BOOST_REQUIRE_MESSAGE(same(accurate, optics.map(point, LensMapping::exhaustive)),
                                  s.sheet);
        }
    }
    BOOST_TEST(imaged > systems); // enough of the points tried image something
}

BOOST_AUTO_TEST_CASE(closest_is_part_of_automatic)
{
    random_sheets::Generator random(78);
    int searched = 0;
    for (int k = 0; k < 5000; ++k) {
        const System s = random_system(random);
        const SheetOptics optics(s.sheet, s.aperture);
        for (int i = 0; i < 20; ++i) {
            const Vec2 point{random.between(-40, 40) * s.sheet.pitch,
                             random.between(-40, 40) * s.sheet.pitch};
            const MappedPoint closest = optics.map(point, LensMapping::closest);
            const MappedPoint automatic = optics.map(point, LensMapping::automatic);
            if (closest.ray) {
                BOOST_TEST(same(closest, automatic));
                BOOST_TEST(!automatic.searched);
            } else if (automatic.ray) {
                ++searched;
                BOOST_TEST(same(automatic, optics.map(point, LensMapping::accurate)));
            }
            BOOST_TEST((automatic.empty == Empty::none) == automatic.ray.has_value());
        }
    }
    BOOST_TEST(searched > 100);
}

BOOST_AUTO_TEST_CASE(mirrored_sheets_image_mirrored_points)
{
    random_sheets::Generator random(79);
    for (int k = 0; k < 3000; ++k) {
        System s = random_system(random);
        System mirrored = s;
        mirrored.sheet.slant = -s.sheet.slant;
        mirrored.sheet.offset.x = -s.sheet.offset.x;
        const SheetOptics optics(s.sheet, s.aperture), mirror(mirrored.sheet, mirrored.aperture);
        for (int i = 0; i < 10; ++i) {
            const Vec2 point{random.between(-20, 20) * s.sheet.pitch,
                             random.between(-20, 20) * s.sheet.pitch};
            const auto a = optics.map(point, LensMapping::accurate),
                       b = mirror.map({-point.x, point.y}, LensMapping::accurate);
            BOOST_REQUIRE_MESSAGE(a.ray.has_value() == b.ray.has_value(), s.sheet);
            if (a.ray)
                BOOST_TEST(std::fabs(a.ray->aperture_point.x + b.ray->aperture_point.x) <=
                           1e-6 * (1 + s.aperture.distance));
        }
    }
}

BOOST_AUTO_TEST_CASE(the_eye_at_the_centre_sees_the_centre)
{
    // micro-images are displaced outwards: a lens at xl images the aperture's centre
    // xl t/sqrt(n^2 d^2 + (n^2 - 1) xl^2) beyond its own axis (optics.md section 4)
    const LensSheet sheet;
    const double d = 300, n = sheet.ior, t = sheet.thickness;
    const SheetOptics optics(sheet, Aperture{d, 1e-3, 0});
    for (int i = -60; i <= 60; ++i) {
        const double xl = i * sheet.pitch;
        const double x = xl + xl * t / std::sqrt(n * n * d * d + (n * n - 1) * xl * xl);
        const auto mapped = optics.map({x, 0}, LensMapping::accurate);
        BOOST_REQUIRE(mapped.ray);
        BOOST_TEST(mapped.ray->lens.i == i);
        BOOST_TEST(std::fabs(mapped.ray->aperture_point.x) < 1e-9);
    }
}

BOOST_AUTO_TEST_CASE(what_closest_alone_loses)
{
    // optics.md section 4: 19% of a frame at angle 30, 49% at POV-Ray's default (1.27/3.08/1.6
    // lenticular). An odd width: with an even one, every fifteenth pixel is a tie and survives.
    CameraParameters parameters;
    parameters.mapping = LensMapping::closest;
    const auto lost = [&](double direction, int width) {
        const ViewFrame view{{0, 0, 0}, {0, 0, direction}, {1.33, 0, 0}, {0, 1, 0}, 1};
        return 1 - coverage(make_camera(parameters, view, width, width * 3 / 4), 200000).imaged;
    };
    const double angle_30 = 1.33 / 2 / std::tan(15 * 3.14159265358979 / 180);
    BOOST_TEST(lost(angle_30, 801) == 0.19, boost::test_tools::tolerance(0.04));
    BOOST_TEST(lost(1, 801) == 0.49, boost::test_tools::tolerance(0.04));
}

BOOST_AUTO_TEST_CASE(scene_and_units_scale_together)
{
    CameraParameters parameters;
    parameters.sheet.arrangement = Arrangement::square;
    for (double scale : {1e-5, 1.0, 1e5}) {
        const ViewFrame view{
            {0, scale, -10 * scale}, {0, 0, 3}, {1.5, 0, 0}, {0, 1, 0}, 10 * scale / 3};
        const IntegralCamera camera = make_camera(parameters, view, 600, 400);
        BOOST_TEST(camera.optics.aperture().distance == 10 / (5 / (600 * mm_per_inch / 300)),
                   boost::test_tools::tolerance(1e-12));
        BOOST_TEST(camera.placement.origin.y == scale, boost::test_tools::tolerance(1e-12));
    }
}

BOOST_AUTO_TEST_CASE(sight_lines_start_at_the_aperture_and_pass_the_pole)
{
    CameraParameters parameters;
    const ViewFrame view{{1, 2, 3}, {0, 0, 2}, {-1.5, 0, 0}, {0, 1, 0}, 4};
    const IntegralCamera camera = make_camera(parameters, view, 600, 400);
    parameters.depth_range = Vec2{20, 50};
    const IntegralCamera limited = make_camera(parameters, view, 600, 400);
    parameters.depth_range = Vec2{1e9, 50}; // beyond the aperture, the range ends at the eye
    const IntegralCamera reaching = make_camera(parameters, view, 600, 400);
    const double k = camera.placement.units_per_mm;
    for (int i = 0; i < 600; i += 7) {
        const auto mapped = camera.optics.map(film_from_pixel(camera.film, {i + 0.5, 100.5}),
                                              LensMapping::automatic);
        if (!mapped.ray)
            continue;
        const SightLine line = sight_line(camera, pole_beam(*mapped.ray)),
                        short_line = sight_line(limited, pole_beam(*mapped.ray));
        // in the plane of the aperture, and on through the pole in the plane of the sheet
        BOOST_TEST(std::fabs(line.origin.z - 3) < 1e-12);
        BOOST_TEST(line.length == 0);
        const double way = (11 - 3) / line.direction.z;
        const Vec3 pole = scene_from_sheet(camera.placement,
                                           {mapped.ray->pole.x, mapped.ray->pole.y, 0});
        BOOST_TEST(length(line.origin + way * line.direction - pole) < 1e-11);
        // the limited line is the same line, from 20 mm before the sheet to 50 mm behind it
        BOOST_TEST(short_line.origin.z == 11 - 20 * k, boost::test_tools::tolerance(1e-12));
        BOOST_TEST((short_line.origin + short_line.length * short_line.direction).z == 11 + 50 * k,
                   boost::test_tools::tolerance(1e-12));
        BOOST_TEST(length(cross(short_line.direction, line.direction)) < 1e-12);
        BOOST_TEST(length(cross(short_line.origin - pole, line.direction)) < 1e-11);
        const SightLine long_line = sight_line(reaching, pole_beam(*mapped.ray));
        BOOST_TEST(length(long_line.origin - line.origin) == 0);
        BOOST_TEST((long_line.origin + long_line.length * long_line.direction).z == 11 + 50 * k,
                   boost::test_tools::tolerance(1e-12));
    }
}

BOOST_AUTO_TEST_SUITE_END()
