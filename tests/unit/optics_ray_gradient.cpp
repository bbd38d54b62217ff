// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the derivatives of a film point's pole ray against differences of rays, for all lenses and
// slants.
#include "integral/optics/beam.h"
#include "integral/optics/ray_gradient.h"
#include "tests/unit/optics_sheets.h"

#include <boost/test/unit_test.hpp>

using namespace integral;

namespace {

/// A ray's two points; empty if there is no ray.
using Points = std::optional<RayShift>;

/// The central difference of at(h), mm per mm. Empty if a ray is missing.
template <class At> Points difference(double h, At at)
{
    const Points before = at(-h), after = at(h);
    if (!before || !after)
        return std::nullopt;
    const double scale = 0.5 / h;
    return RayShift{scale * (after->pole - before->pole),
                    scale * (after->aperture - before->aperture)};
}

double distance(const RayShift& a, const RayShift& b)
{
    return std::hypot(length(a.pole - b.pole), length(a.aperture - b.aperture));
}
double size(const RayShift& a) { return std::hypot(length(a.pole), length(a.aperture)); }

} // namespace

BOOST_AUTO_TEST_SUITE(optics_ray_gradient)

BOOST_AUTO_TEST_CASE(gradients_are_differences_of_rays)
{
    random_sheets::Generator random(11);
    int compared = 0;
    for (int trial = 0; trial < random_sheets::count(4000, 100000); ++trial) {
        LensSheet sheet = random.sheet();
        sheet.pitch = random.between(0.2, 3);
        sheet.thickness = sheet.pitch * random.between(1, 5);
        sheet.ior = random.one_in(6) ? 1 : random.between(1, 2);
        sheet.offset = {random.between(-1, 1), random.between(-1, 1)};
        Aperture aperture;
        aperture.distance = random.between(100, 1000);
        aperture.width = aperture.height = 1e9;
        const SheetOptics optics(sheet, aperture);
        const Vec2 film{random.between(-100, 100), random.between(-100, 100)};
        const LensIndex lens = optics.lattice().nearest(film);
        const auto ray = optics.ray_through(film, lens);
        if (!ray || ray->direction.z > -0.3) // near total reflection, differences have no digits
            continue;
        const RayGradient g = ray_gradient(optics, film, *ray);
        const auto moved = [&](Vec2 by) -> Points {
            const auto other = optics.ray_through(film + by, lens);
            return other ? Points(RayShift{other->pole, other->aperture_point}) : std::nullopt;
        };
        const double h = 1e-5 * sheet.thickness;
        const auto x = difference(h, [&](double by) { return moved({by, 0}); });
        const auto y = difference(h, [&](double by) { return moved({0, by}); });
        BOOST_REQUIRE(x && y);
        BOOST_CHECK_MESSAGE(distance(*x, g.x) <= 1e-6 * size(g.x),
                            sheet << ": along x, off by " << distance(*x, g.x) / size(g.x));
        BOOST_CHECK_MESSAGE(distance(*y, g.y) <= 1e-6 * size(g.y),
                            sheet << ": along y, off by " << distance(*y, g.y) / size(g.y));
        ++compared;
        if (sheet.arrangement != Arrangement::lenticular) {
            BOOST_CHECK_EQUAL(size(g.slit), 0);
            continue;
        }
        const auto slit = difference(1e-3, [&](double eta) -> Points {
            const auto beam = beam_ray(optics, film, lens, {{0, 0}, eta});
            return beam ? Points(RayShift{{beam->point.x, beam->point.y}, beam->aperture_point})
                        : std::nullopt;
        });
        BOOST_REQUIRE(slit);
        BOOST_CHECK_MESSAGE(distance(*slit, g.slit) <= 1e-6 * size(g.slit),
                            sheet << ": along the slit, off by "
                                  << distance(*slit, g.slit) / size(g.slit));
    }
    BOOST_CHECK_GT(compared, random_sheets::count(4000, 100000) / 2);
}

// Hand values on the axis: dA/dF = -n d/t for a square lens; (P, A) along an upright lenticular
// lens's axis move by n d/(n d + t) and 0, and across it by 0 and -n d/t.
BOOST_AUTO_TEST_CASE(on_the_axis)
{
    LensSheet sheet{Arrangement::square, 1, 3, 1.5, 0, {}};
    const Aperture aperture{300, 100, 100};
    const auto at_pole = [&] {
        const SheetOptics optics(sheet, aperture);
        return ray_gradient(optics, {0, 0}, *optics.ray_through({0, 0}, {0, 0}));
    };
    const RayGradient square = at_pole();
    BOOST_CHECK_CLOSE(square.x.aperture.x, -150, 1e-10);
    BOOST_CHECK_CLOSE(square.y.aperture.y, -150, 1e-10);
    BOOST_CHECK_EQUAL(length(square.x.pole), 0);
    sheet.arrangement = Arrangement::lenticular;
    const RayGradient lenticular = at_pole();
    BOOST_CHECK_CLOSE(lenticular.x.aperture.x, -150, 1e-10);
    BOOST_CHECK_SMALL(length(lenticular.x.pole), 1e-12);
    BOOST_CHECK_CLOSE(lenticular.y.pole.y, 450 / 453., 1e-10);
    BOOST_CHECK_SMALL(length(lenticular.y.aperture), 1e-9);
    BOOST_CHECK_CLOSE(lenticular.slit.aperture.y, 1, 1e-10);
    BOOST_CHECK_CLOSE(lenticular.slit.pole.y, 3 / 453., 1e-10); // t/(n d + t)
}

BOOST_AUTO_TEST_SUITE_END()
