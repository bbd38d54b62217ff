// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the steps of the search for a scan's lens lattice, on drawings with a known lattice. These
// are small, with about 30 lenses; tests/cli/integral_rectify.test has larger scans and stricter
// limits.
#include "integral/analysis/border_fit.h"
#include "integral/analysis/lattice_search.h"
#include "integral/analysis/lens_borders.h"
#include "integral/analysis/rectify_report.h"
#include "integral/analysis/lattice_phases.h"
#include "integral/analysis/spectrum.h"
#include "integral/base/file_bytes.h"

#include <boost/test/unit_test.hpp>

#include <random>

using namespace integral;

BOOST_AUTO_TEST_SUITE(analysis_lattice)

namespace {

constexpr double pi = 3.14159265358979323846;

LensSheet sheet_of(Arrangement arrangement, double slant = 0)
{
    LensSheet sheet;
    sheet.arrangement = arrangement;
    sheet.slant = slant;
    sheet.offset = {0.21, -0.17};
    return sheet;
}

LatticeSearch search_for(const LensSheet& sheet, const ScanMap& about)
{
    LatticeSearch search;
    search.sheet = sheet;
    search.aperture = *filling_aperture(sheet, 300);
    search.about = about;
    return search;
}

/// A scan in which each lens has one random grey, so that it shows the lenses' borders only. Drawn
/// with 3 x 3 samples a pixel. map_at(x, y): the map at a pixel.
template <class MapAt>
Image chance_greys_by(const LatticeSearch& search, MapAt map_at, int width, int height,
                      double noise)
{
    const SheetOptics optics(search.sheet, search.aperture);
    Image scan = make_image<std::uint8_t>(width, height, 3, Encoding{});
    std::mt19937 random(7);
    std::normal_distribution<double> normal(0, noise);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const ScanMap map = map_at(x, y);
            double sum = 0;
            for (int k = 0; k < 9; ++k) {
                const Vec2 pixel{x + (k % 3 + 0.5) / 3, y + (k / 3 + 0.5) / 3};
                const auto mapped = optics.map(film_from_scan(map, pixel), search.mapping);
                if (mapped.ray) {
                    const std::uint32_t mixed = std::uint32_t(mapped.ray->lens.i * 73856093 ^
                                                              mapped.ray->lens.j * 19349663) *
                                                2654435761u;
                    sum += 0.2 + 0.6 * (mixed >> 8) / double(1 << 24);
                }
            }
            const float grey = float(sum / 9 + normal(random));
            store_pixel(scan, x, y, {grey, grey, grey, 1});
        }
    return scan;
}

Image chance_greys(const LatticeSearch& search, const ScanMap& map, int width, int height,
                   double noise)
{
    return chance_greys_by(
        search, [&](int, int) { return map; }, width, height, noise);
}

/// The message of find_sure_lattice's InputError; "" if it finds a lattice.
std::string refusal(const Image& scan, const LatticeSearch& search)
{
    try {
        find_sure_lattice("scan.png", scan, search, 1, {});
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

} // namespace

BOOST_AUTO_TEST_CASE(a_map_and_its_inverse)
{
    const ScanMap map{{812.5, 377.25}, {23.5, 23.75}, 0.31};
    for (const Vec2 point : {Vec2{0, 0}, Vec2{12.5, -3}, Vec2{-40, 17}}) {
        const Vec2 back = film_from_scan(map, scan_from_film(map, point));
        BOOST_CHECK_SMALL(length(back - point), 1e-12);
        BOOST_CHECK_SMALL(length(3.0 * scan_from_film(in_larger_pixels(map, 3), point) -
                                 scan_from_film(map, point)),
                          1e-9);
    }
    // A quarter turn anticlockwise: right becomes up, which is less y.
    const Vec2 up = scan_from_film({{100, 100}, {10, 20}, pi / 2}, {1, 0});
    BOOST_CHECK_SMALL(length(up - Vec2{100, 80}), 1e-9);
}

BOOST_AUTO_TEST_CASE(a_wave_is_at_its_frequency)
{
    Plane plane{96, 80, std::vector<float>(96 * 80), 0};
    const Vec2 frequency{0.13, -0.21};
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 96; ++x)
            plane.at(x, y) = float(5 + std::cos(2 * pi * (frequency.x * x + frequency.y * y)));
    const Spectrum spectrum(plane, 64);
    BOOST_CHECK_EQUAL(spectrum.extent(), 64);
    double most = 0;
    Vec2 where;
    for (double fx = 0; fx < 0.49; fx += 0.005)
        for (double fy = -0.49; fy < 0.49; fy += 0.005)
            if (spectrum.power({fx, fy}) > most) {
                most = spectrum.power({fx, fy});
                where = {fx, fy};
            }
    BOOST_CHECK_SMALL(length(where - frequency), 0.006);
    BOOST_CHECK_CLOSE(spectrum.power(frequency), spectrum.power(-1.0 * frequency), 1e-9);
    BOOST_CHECK_GT(spectrum.power(frequency), 20);
    BOOST_CHECK_EQUAL(spectrum.power({0.6, 0}), 0);
}

BOOST_AUTO_TEST_CASE(an_edge_response_does_not_depend_on_the_light)
{
    Image bright = make_image<std::uint16_t>(60, 40, 3, Encoding{}), dim = bright;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 60; ++x) {
            const float v = x % 15 < 7 ? 0.4f : 0.8f;
            store_pixel(bright, x, y, {v, v, v, 1});
            store_pixel(dim, x, y, {0.25f * v, 0.25f * v, 0.25f * v, 1});
        }
    const Plane a = edge_response(bright, 1, 20, 1), b = edge_response(dim, 1, 20, 1);
    for (std::size_t k = 0; k < a.values.size(); ++k)
        BOOST_REQUIRE_SMALL(a.values[k] - b.values[k], 2e-3f);
    BOOST_CHECK_GT(a.at(7, 20), 0.7); // next to the step from 6 to 7
    BOOST_CHECK_EQUAL(a.at(3, 20), 0);
}

BOOST_AUTO_TEST_CASE(borders_lie_where_the_aperture_ends)
{
    // Without displacement (an eye at infinity) the borders are halfway between the lenses.
    LensSheet sheet = sheet_of(Arrangement::lenticular, 20);
    const SheetOptics far(sheet, *filling_aperture(sheet, 1e8));
    const Lattice lattice(sheet);
    const auto borders = lens_borders(far, LensMapping::automatic, {10, 8}, 0.2, 2000, 1);
    BOOST_CHECK_GT(borders.size(), 300u);
    for (const Vec2 point : borders) {
        const double u = dot(lattice.across(), point - sheet.offset) / sheet.pitch - 0.5;
        BOOST_REQUIRE_SMALL(u - std::round(u), 1e-3);
    }
    // A near eye displaces them by x t/sqrt(n^2 d^2 + (n^2 - 1) x^2). The lenses are upright, the
    // points on the horizontal axis.
    sheet.slant = 0;
    const SheetOptics near(sheet, *filling_aperture(sheet, 200));
    const double m = sheet.ior * sheet.ior - 1;
    for (const Vec2 point : lens_borders(near, LensMapping::accurate, {8, 0.01}, 0.2, 2000, 1)) {
        double pole = point.x; // found by iteration: the place whose displacement leads to point.x
        for (int k = 0; k < 50; ++k)
            pole = point.x - pole * sheet.thickness /
                                 std::sqrt(sheet.ior * sheet.ior * 200 * 200 + m * pole * pole);
        const double u = (pole - sheet.offset.x) / sheet.pitch - 0.5;
        BOOST_REQUIRE_SMALL(u - std::round(u), 0.01);
    }
    // Borders between the pixels of a frame are on the pixels' edges.
    Film film{300, 200, {0.0847, 0.0847}, Subpixels::none};
    for (const Vec2 point : lens_borders_of_pixels(near, LensMapping::automatic, film, 2000, 1)) {
        const double x = pixel_from_film(film, point).x;
        BOOST_REQUIRE_SMALL(x - std::round(x), 1e-9);
    }
}

BOOST_AUTO_TEST_CASE(a_lattice_is_found, *boost::unit_test::label("many_pixels"))
{
    for (const auto& [arrangement, slant] :
         {std::pair(Arrangement::lenticular, 0.0), std::pair(Arrangement::lenticular, -14.0),
          std::pair(Arrangement::square, 0.0), std::pair(Arrangement::hexagonal, 0.0)}) {
        const double turn = arrangement == Arrangement::square ? 0.6 : -1.9;
        const LensSheet sheet = sheet_of(arrangement, slant);
        const bool lenticular = arrangement == Arrangement::lenticular;
        const ScanMap truth{{301.3, 248.8}, {12.1, lenticular ? 12.1 : 12.03}, turn * pi / 180};
        const LatticeSearch search = search_for(sheet, {{302, 247}, {12, 12}, 0});
        const auto found = find_lattice(chance_greys(search, truth, 600, 500, 0.03), search);
        BOOST_TEST_CONTEXT("arrangement " << int(arrangement) << " slant " << slant << " turn "
                                          << turn)
        {
            BOOST_REQUIRE(found);
            BOOST_CHECK_GT(found->significance, 2 * least_significance);
            BOOST_CHECK_SMALL(found->map.scale.x / truth.scale.x - 1, 2.5e-4);
            BOOST_CHECK_SMALL(found->map.scale.y / truth.scale.y - 1, 2.5e-4);
            BOOST_CHECK_SMALL(found->map.rotation - truth.rotation, 2e-4);
            const Vec2 off = found->map.middle - truth.middle;
            const Vec2 b = Lattice(sheet).across();
            const Vec2 across{b.x * std::cos(truth.rotation) - b.y * std::sin(truth.rotation),
                              -(b.x * std::sin(truth.rotation) + b.y * std::cos(truth.rotation))};
            BOOST_CHECK_SMALL(lenticular ? dot(off, across) : length(off), 0.08);
            BOOST_CHECK_GT(found->scale_error.x, 0);
            BOOST_CHECK_LT(found->scale_error.x, 2e-4);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_picture_of_two_lattices_is_refused)
{
    // The greys change equally at the lenses' borders and in the lenses' middles.
    const LensSheet sheet = sheet_of(Arrangement::lenticular);
    const ScanMap truth{{201.5, 150.5}, {12, 12}, 0.01};
    const LatticeSearch search = search_for(sheet, {{200, 150}, {12, 12}, 0});
    const Image one = chance_greys(search, truth, 400, 300, 0.01);
    ScanMap beside = truth;
    beside.middle.x += 0.5 * sheet.pitch * truth.scale.x;
    const Image other = chance_greys(search, beside, 400, 300, 0.01);
    Image both = one;
    for (int y = 0; y < both.height; ++y)
        for (int x = 0; x < both.width; ++x) {
            const float v = 0.5f * (stored_pixel(one, x, y).r + stored_pixel(other, x, y).r);
            store_pixel(both, x, y, {v, v, v, 1});
        }
    BOOST_CHECK_EQUAL(refusal(one, search), "");
    const std::string said = refusal(both, search);
    BOOST_TEST_CONTEXT("said: " << said)
    BOOST_CHECK(said.find("scan.png: two lattices fit it equally well") == 0);
}

BOOST_AUTO_TEST_CASE(a_scan_whose_parts_disagree_is_refused)
{
    // Four quarters, each with the same lattice at another place.
    const LensSheet sheet = sheet_of(Arrangement::square);
    const LatticeSearch search = search_for(sheet, {{240, 180}, {12, 12}, 0});
    const Image scan = chance_greys_by(
        search,
        [&](int x, int y) {
            const double lenses = x < 240 ? (y < 180 ? 0 : 0.3) : (y < 180 ? 0.55 : 0.8);
            const double by = lenses * sheet.pitch * 12;
            return ScanMap{{240 + by, 180 + 0.6 * by}, {12, 12}, 0};
        },
        480, 360, 0.02);
    const std::string said = refusal(scan, search);
    BOOST_TEST_CONTEXT("said: " << said)
    BOOST_CHECK(said.find("disagree") != said.npos || said.find("equally well") != said.npos);
}

BOOST_AUTO_TEST_CASE(distances_of_lattices_leave_whole_lenses_out)
{
    const LensSheet sheet = sheet_of(Arrangement::hexagonal);
    const ScanMap map{{300, 200}, {20, 20}, 0};
    ScanMap moved = map;
    moved.middle.x += 3.5 * sheet.pitch * 20;
    moved.middle.y -= std::sqrt(0.75) * sheet.pitch * 20; // a row up, half a lens aside
    BOOST_CHECK_SMALL(lenses_apart(sheet, map, moved, 600, 400), 1e-9);
    moved.middle.x += 0.25 * sheet.pitch * 20;
    BOOST_CHECK_CLOSE(lenses_apart(sheet, map, moved, 600, 400), 0.25, 1e-6);
}

BOOST_AUTO_TEST_CASE(unknown_errors_are_reported_as_unknown)
{
    FoundLattice found;
    found.map = {{200, 150}, {12, 12}, 0};
    const LatticeSearch search = search_for(sheet_of(Arrangement::square), found.map);
    const Film film{300, 200, {0.0847, 0.0847}, Subpixels::none};
    const std::string unknown = rectify_text(found, search, film, {});
    BOOST_CHECK(unknown.find("+- unknown\n") != unknown.npos);
    BOOST_CHECK(unknown.find("+- 0") == unknown.npos);
    BOOST_CHECK(rectify_json(found, search, film, {})["standard_error"].is_null());
    found.errors_known = true;
    found.scale_error = {0.0004, 0.0002};
    const std::string known = rectify_text(found, search, film, {});
    BOOST_CHECK(known.find("+- 0.0400, 0.0200%\n") != known.npos);
    BOOST_CHECK(known.find("unknown") == known.npos);
}

BOOST_AUTO_TEST_CASE(noise_has_no_lattice)
{
    Image scan = make_image<std::uint8_t>(400, 300, 3, Encoding{});
    std::mt19937 random(3);
    std::uniform_real_distribution<float> grey(0, 1);
    for (int y = 0; y < 300; ++y)
        for (int x = 0; x < 400; ++x) {
            const float v = grey(random);
            store_pixel(scan, x, y, {v, v, v, 1});
        }
    for (const Arrangement arrangement :
         {Arrangement::lenticular, Arrangement::square, Arrangement::hexagonal}) {
        const auto found = find_lattice(
            scan, search_for(sheet_of(arrangement), {{200, 150}, {12, 12}, 0}));
        BOOST_REQUIRE(found);
        BOOST_CHECK_LT(found->significance, least_significance);
    }
    BOOST_CHECK_THROW(
        find_lattice(scan, search_for(sheet_of(Arrangement::square), {{200, 150}, {2, 2}, 0})),
        std::invalid_argument);
    BOOST_CHECK_THROW(
        find_lattice(scan, search_for(sheet_of(Arrangement::square), {{200, 150}, {40, 40}, 0})),
        std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
