// SPDX-License-Identifier: AGPL-3.0-or-later
// Searches behind low and narrow apertures: few lenses are tried, and none that counts is left out.
#include "integral/optics/lens_box.h"
#include "tests/unit/optics_properties.h"

#include <boost/test/unit_test.hpp>

using namespace random_systems;

BOOST_AUTO_TEST_SUITE(optics_lens_box)

namespace {

/// A system whose aperture is low, and either many lenses wide or of unlimited width.
System low_system(Generator& random)
{
    System s = plain_system(random);
    if (s.lenticular())
        s.sheet.arrangement = random.one_in(2) ? Arrangement::square : Arrangement::hexagonal;
    const double filling = s.sheet.pitch * s.stretch();
    s.aperture.width = random.one_in(5) ? infinity : filling * random.log_between(1, 30);
    s.aperture.height = filling * random.log_between(1e-4, 1);
    if (random.one_in(2))
        std::swap(s.aperture.width, s.aperture.height);
    return s;
}

int lenses_tried(const SheetOptics& optics, Vec2 film_point, Vec2 centre, double radius)
{
    int lenses = 0;
    for_each_within(
        optics.lattice(), centre, radius,
        box_of_passing_poles(optics.aperture(), optics.medium(), film_point, centre, radius),
        [&](LensIndex) { ++lenses; });
    return lenses;
}

} // namespace

BOOST_AUTO_TEST_CASE(every_lens_that_passes_light_is_in_the_box)
{
    Generator random(53);
    int passing = 0, left_out = 0;
    for (int k = 0; k < 3000; ++k) {
        const System s = low_system(random);
        const SheetOptics optics = s.optics();
        const Vec2 point = plain_film_point(random, s, 30),
                   centre = (1 - 1 / s.stretch()) * point + plain_film_point(random, s, 8);
        const double radius = random.between(0, 12) * s.sheet.pitch;
        std::vector<LensIndex> all, boxed;
        const auto passes = [&](LensIndex lens) {
            const auto ray = optics.ray_through(point, lens);
            return ray && contains(s.aperture, ray->aperture_point);
        };
        optics.lattice().for_each_within(centre, radius, [&](LensIndex lens) {
            if (passes(lens))
                all.push_back(lens);
            else
                ++left_out;
        });
        for_each_within(optics.lattice(), centre, radius,
                        box_of_passing_poles(s.aperture, optics.medium(), point, centre, radius),
                        [&](LensIndex lens) {
                            if (passes(lens))
                                boxed.push_back(lens);
                        });
        passing += int(all.size());
        BOOST_TEST_CONTEXT(s << " film point <" << point.x << ", " << point.y << ">")
        BOOST_REQUIRE(all == boxed); // in the same order
    }
    BOOST_TEST(passing > 1000);
    BOOST_TEST(left_out > 3000);
}

BOOST_AUTO_TEST_CASE(a_low_aperture_does_not_make_a_search_try_all_lenses_around)
{
    // Lenses of 0.01 mm behind an aperture 187 of them wide and nearly without height.
    for (const double slant : {0.0, 30.0, 90.0})
        for (const Arrangement arrangement : {Arrangement::square, Arrangement::hexagonal}) {
            const LensSheet sheet{arrangement, 0.01, 3, 1.6, slant, {}};
            const SheetOptics optics(sheet, {300, 300, 0.001, ApertureShape::rectangle});
            const double radius = 94 * sheet.pitch;
            for (const Vec2 point : {Vec2{0, 0}, Vec2{20, 3}, Vec2{-50, 50}}) {
                const Vec2 centre = (1 - 1 / (1 + 1.6 * 300 / 3)) * point;
                int around = 0;
                optics.lattice().for_each_within(centre, radius, [&](LensIndex) { ++around; });
                const int tried = lenses_tried(optics, point, centre, radius);
                BOOST_TEST(around > 35000);
                BOOST_TEST(tried < 2500, slant << " degrees: " << tried << " lenses are tried");
            }
        }
}

BOOST_AUTO_TEST_SUITE_END()
