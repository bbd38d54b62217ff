// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests properties of every lens mapping for random sheets in the ranges of optics.md section 7:
// accurate equals exhaustive, closest is part of auto, the rule that selects the lens of a point,
// and finite results even for extreme input.
#include "tests/unit/optics_properties.h"

#include <boost/test/unit_test.hpp>

#include <optional>
#include <vector>

using namespace random_systems;

namespace {

/// How far from a film point a lens can be that sends its light through the aperture.
double farthest_lens(const System& s, Vec2 film_point)
{
    const double circumradius = 0.5 * std::hypot(s.aperture.width, s.aperture.height);
    return std::min(s.total_reflection(), (circumradius + length(film_point)) / s.stretch());
}

} // namespace

BOOST_AUTO_TEST_SUITE(optics_properties)

BOOST_AUTO_TEST_CASE(accurate_is_exhaustive_and_closest_is_part_of_automatic)
{
    Generator random(77);
    const int systems = random_sheets::count(10000, 1000000);
    long compared = 0, imaged = 0, searched = 0, rule = 0;
    for (int k = 0; k < systems; ++k) {
        const System s = random_system(random);
        const SheetOptics optics = s.optics();
        for (int i = 0; i < 6; ++i) {
            const Vec2 point = random_film_point(random, s, optics);
            BOOST_TEST_CONTEXT(s << " film point <" << point.x << ", " << point.y << ">")
            {
                const MappedPoint closest = optics.map(point, LensMapping::closest);
                const MappedPoint automatic = optics.map(point, LensMapping::automatic);
                const MappedPoint accurate = optics.map(point, LensMapping::accurate);
                // Where rounding decides whether light is totally reflected, the reasons for having
                // no ray may differ.
                const bool grazing = length(point) > 1e4 * s.aperture.distance;
                if (farthest_lens(s, point) < 30 * s.sheet.pitch) {
                    const MappedPoint exhaustive = optics.map(point, LensMapping::exhaustive);
                    BOOST_TEST_REQUIRE(equal(accurate, exhaustive));
                    BOOST_TEST((grazing || accurate.empty == exhaustive.empty));
                    ++compared;
                }
                BOOST_TEST_REQUIRE(equal(automatic, closest.ray ? closest : accurate));
                // A search does not reach lenses that are hundreds of pitches away.
                const bool missed = closest.ray && !accurate.ray;
                if (farthest_lens(s, {0, 0}) < 60 * s.sheet.pitch)
                    BOOST_TEST_REQUIRE(!missed);
                BOOST_TEST(automatic.searched == !closest.ray);
                BOOST_TEST((grazing || missed || accurate.empty == automatic.empty));
                BOOST_TEST((grazing || accurate.ray || missed || closest.empty == accurate.empty));
                BOOST_TEST(accurate.searched);
                for (const MappedPoint& mapped : {closest, automatic, accurate})
                    BOOST_TEST((mapped.empty == Empty::none) == mapped.ray.has_value());
                rule += closest.ray.has_value();
                imaged += accurate.ray.has_value();
                searched += automatic.ray && !closest.ray;
            }
        }
    }
    // There were enough points of every kind.
    BOOST_TEST(compared > 4 * systems);
    BOOST_TEST(imaged > 2 * systems);
    BOOST_TEST(rule > systems);
    BOOST_TEST(searched > systems / 10);
}

BOOST_AUTO_TEST_CASE(exhaustive_is_the_rule_written_down)
{
    // The rule selects the lens whose ray passes the aperture nearest to its centre; if others are
    // within 1e-9 pitches of that, the rule for ties decides.
    Generator random(76);
    const int systems = random_sheets::count(2000, 100000);
    int imaged = 0, tied = 0;
    for (int k = 0; k < systems; ++k) {
        System s = plain_system(random);
        s.aperture.width = s.aperture.height = std::max(s.aperture.width, s.aperture.height);
        if (random.one_in(2)) { // the centre of the sheet between lenses: an axis of symmetry
            const Lattice lattice(s.sheet);
            const bool both = random.one_in(2) && !s.lenticular();
            s.sheet.offset = 0.5 * s.sheet.pitch *
                             (lattice.across() + (both ? 1.0 : 0.0) * lattice.along());
        }
        const SheetOptics optics = s.optics();
        const Lattice& lattice = optics.lattice();
        const double near_0 = random.one_in(2) ? 0
                                               : random.log_between(1e-13, 1e-9) * s.sheet.pitch;
        const Vec2 point = random.one_in(2) ? near_0 * direction_at(random.between(0, 6.3))
                                            : random_film_point(random, s, optics);
        if (farthest_lens(s, point) > 20 * s.sheet.pitch)
            continue;
        const double tie = lattice.tie_tolerance();
        std::vector<LensRay> passing;
        double least = infinity;
        lattice.for_each_within(
            point, farthest_lens(s, point) + 1e-3 * s.sheet.pitch, [&](LensIndex lens) {
                const auto ray = optics.ray_through(point, lens);
                Aperture slit = s.aperture;
                if (s.lenticular())
                    (slit_is_horizontal(s.sheet) ? slit.height : slit.width) = infinity;
                if (!ray || !contains(slit, ray->aperture_point))
                    return;
                passing.push_back(*ray);
                least = std::min(least, length(ray->aperture_point));
            });
        std::optional<LensRay> best;
        int candidates = 0;
        for (const LensRay& ray : passing)
            if (length(ray.aperture_point) <= least + tie) {
                ++candidates;
                if (!best || lattice.preferred(ray.lens, best->lens))
                    best = ray;
            }
        imaged += best.has_value();
        tied += candidates > 1;
        const MappedPoint mapped = optics.map(point, LensMapping::exhaustive);
        BOOST_TEST_CONTEXT(s << " film point <" << point.x << ", " << point.y << ">")
        {
            BOOST_TEST_REQUIRE(mapped.ray.has_value() == best.has_value());
            BOOST_TEST((!best || equal(*mapped.ray, *best)));
            BOOST_TEST(equal(optics.map(point, LensMapping::accurate), mapped));
        }
    }
    BOOST_TEST(imaged > systems / 2);
    BOOST_TEST(tied > systems / 20);
}

BOOST_AUTO_TEST_CASE(aperture_points_of_two_lenses_keep_apart)
{
    // The searches assume this (see the head of lens_mapping.cpp).
    Generator random(80);
    const int systems = random_sheets::count(20000, 1000000);
    int pairs = 0;
    for (int k = 0; k < systems; ++k) {
        const System s = random_system(random);
        const SheetOptics optics = s.optics();
        const double away = std::min(s.total_reflection(), 1e3 * s.sheet.pitch);
        const Vec2 point = plain_film_point(random, s, 1000);
        const auto lens = [&] {
            return optics.lattice().nearest(point + random.between(0, away) *
                                                        direction_at(random.between(0, 6.3)));
        };
        const LensIndex one = lens();
        const LensIndex two = random.one_in(2) ? lens() : LensIndex{one.i + 1, one.j};
        const auto a = optics.ray_through(point, one), b = optics.ray_through(point, two);
        if (!a || !b || one == two)
            continue;
        ++pairs;
        const Vec2 way = optics.lattice().pole(two) - optics.lattice().pole(one);
        const Vec2 there = b->aperture_point - a->aperture_point;
        const double far = length(a->aperture_point) + length(b->aperture_point) + length(point);
        BOOST_TEST_CONTEXT(s << " film point <" << point.x << ", " << point.y << "> lenses "
                             << one.i << ", " << one.j << " and " << two.i << ", " << two.j)
        {
            if (s.lenticular()) {
                const double g = dot(optics.slit().normal, optics.slit().axis);
                BOOST_TEST(length(there) >=
                           s.stretch() * length(way) * 2 / (1 + g) * (1 - 1e-9) - 1e-9 * far);
            } else
                BOOST_TEST(dot(way, there) >=
                           length(way) * (s.stretch() * length(way) * (1 - 1e-9) - 1e-9 * far));
        }
    }
    BOOST_TEST(pairs > systems / 4);
}

BOOST_AUTO_TEST_CASE(hostile_values_are_answered)
{
    Generator random(85);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    long points = 0, imaged = 0;
    for (int arrangement = 0; arrangement < 3; ++arrangement)
        for (double thickness : {0.02, 2.4, 1e4})
            for (double ior : {1.0, 1 + 1e-12, 1.001, 1.6, 4.0})
                for (double slant : {0.0, 18.4349, -89.99, 90.0})
                    for (double distance : {1e-2, 300.0, 1e9})
                        for (double extent : {0.0, 1e-3, 1.0, 1e12, infinity}) {
                            System s{{Arrangement(arrangement), 1, thickness, ior, slant, {0.5, 0}},
                                     {distance, extent, extent}};
                            if (extent == 1) // the width fills a lens, the height is unlimited
                                s.aperture = {distance, s.stretch(), infinity};
                            s.aperture.shape = random.one_in(2) ? ApertureShape::ellipse
                                                                : ApertureShape::rectangle;
                            const SheetOptics optics = s.optics();
                            for (double far : {0.0, 1e-300, 0.37, 100.0, 1e6, 1e12, 1e13, 1e300,
                                               infinity, nan}) {
                                const Vec2 point{far, random.one_in(2) ? 0.3 * far
                                                                       : random.between(-1, 1)};
                                const MappedPoint closest = optics.map(point, LensMapping::closest);
                                const MappedPoint automatic = optics.map(point,
                                                                         LensMapping::automatic);
                                const MappedPoint accurate = optics.map(point,
                                                                        LensMapping::accurate);
                                BOOST_TEST_REQUIRE(
                                    equal(automatic, closest.ray ? closest : accurate),
                                    s << " film point <" << point.x << ", " << point.y << ">");
                                for (const MappedPoint& mapped : {closest, automatic, accurate}) {
                                    ++points;
                                    BOOST_TEST((mapped.empty == Empty::none) ==
                                               mapped.ray.has_value());
                                    if (!mapped.ray)
                                        continue;
                                    ++imaged;
                                    BOOST_TEST(far < 1e9);
                                    const LensRay& ray = *mapped.ray;
                                    for (double value :
                                         {ray.pole.x, ray.pole.y, ray.aperture_point.x,
                                          ray.aperture_point.y})
                                        BOOST_TEST(std::isfinite(value), s);
                                    BOOST_TEST(std::fabs(length(ray.direction) - 1) < 1e-9, s);
                                    BOOST_TEST(ray.direction.z < 0, s);
                                }
                            }
                        }
    BOOST_TEST(imaged > points / 10);
}

BOOST_AUTO_TEST_SUITE_END()
