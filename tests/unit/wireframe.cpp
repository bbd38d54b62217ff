// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests which pixels points, lines and faces light, in comparison with the renderer's own mapping
// of every pixel.
#include "integral/wireframe/lens_pixels.h"
#include "integral/wireframe/lens_rays.h"
#include "integral/wireframe/wireframe.h"
#include "integral/wireframe/wireframe_report.h"

#include "integral/frame/names.h"
#include "integral/optics/beam.h"

#include <boost/test/unit_test.hpp>

#include <random>
#include <set>

using namespace integral;

namespace {

using Pixels = std::set<std::pair<int, int>>;

LensSheet sheet_of(Arrangement arrangement, double slant = 0)
{
    LensSheet sheet;
    sheet.arrangement = arrangement;
    sheet.slant = slant;
    sheet.offset = {0.2, -0.1};
    return sheet;
}

WireframeRequest request_of(const LensSheet& sheet, LensModel model, double dpi = 300)
{
    const auto aperture = filling_aperture(sheet, 300);
    Film film{240, 180, {25.4 / dpi, 25.4 / dpi}};
    return {{}, SheetOptics(sheet, *aperture, model), film};
}

Image drawn(const WireframeRequest& request)
{
    WireframeCost cost;
    const auto image = draw_wireframe(request, 32, 2, {}, cost);
    BOOST_REQUIRE(image.has_value());
    return *image;
}

Pixels lit(const Image& image)
{
    Pixels pixels;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (stored_pixel(image, x, y).r > 0)
                pixels.insert({x, y});
    return pixels;
}

double sum(const Image& image)
{
    double light = 0;
    for (const auto& [x, y] : lit(image))
        light += stored_pixel(image, x, y).r;
    return light;
}

WireframeRequest with_point(WireframeRequest request, Vec3 point)
{
    request.mesh.vertices = {point};
    request.mesh.points = {{0, {1, 1, 1, 1}}};
    return request;
}

/// The pixels that a point lights, found by trying every lens of the film; does not use the
/// program's search for lenses.
Pixels pixels_of(const WireframeRequest& request, Vec3 point)
{
    const SheetOptics& optics = request.optics;
    std::set<std::pair<std::int64_t, std::int64_t>> lenses;
    const Film& film = request.film;
    const auto lens_of = [&](int x, int y) {
        return optics.map(film_from_pixel(film, {x + 0.5, y + 0.5}), request.mapping).ray;
    };
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x)
            if (const auto ray = lens_of(x, y))
                lenses.insert({ray->lens.i, ray->lens.j});
    Pixels pixels;
    for (const auto& [i, j] : lenses) {
        const auto at = film_point_imaging(optics, point, {i, j});
        if (!at)
            continue;
        const Vec2 pixel = pixel_from_film(film, *at);
        const int x = int(std::floor(pixel.x)), y = int(std::floor(pixel.y));
        if (x < 0 || y < 0 || x >= film.width || y >= film.height)
            continue;
        const auto owner = lens_of(x, y);
        if (!owner || owner->lens != LensIndex{i, j})
            continue;
        pixels.insert({x, y});
        // back along the renderer's ray: through the scene point
        const auto ray = optics.ray_through(*at, {i, j});
        BOOST_REQUIRE(ray.has_value());
        const Vec3 from{ray->pole.x, ray->pole.y, 0};
        BOOST_TEST(length(cross(point - from, ray->direction)) <= 1e-9);
    }
    return pixels;
}

const struct {
    Arrangement arrangement;
    double slant;
} sheets[] = {{Arrangement::lenticular, 0},
              {Arrangement::lenticular, 18},
              {Arrangement::lenticular, -70},
              {Arrangement::square, 10},
              {Arrangement::hexagonal, 0}};

const LensModel all_models[] = {LensModel::pinhole, LensModel::extended_pinhole, LensModel::hybrid,
                                LensModel::full};

} // namespace

BOOST_AUTO_TEST_SUITE(wireframe)

BOOST_AUTO_TEST_CASE(points_light_the_pixels_whose_rays_pass_them)
{
    std::mt19937 engine(3);
    const auto between = [&](double a, double b) {
        return std::uniform_real_distribution<double>(a, b)(engine);
    };
    for (const auto& s : sheets)
        for (const LensModel model : {LensModel::pinhole, LensModel::extended_pinhole})
            for (int k = 0; k < 6; ++k) {
                const auto request = request_of(sheet_of(s.arrangement, s.slant), model);
                const double z = k % 2 ? between(4, 80) : between(-60, -4);
                const Vec3 point{between(-9, 9), between(-7, 7), z};
                const Pixels want = pixels_of(request, point);
                BOOST_TEST(!want.empty());
                BOOST_TEST((lit(drawn(with_point(request, point))) == want));
            }
}

BOOST_AUTO_TEST_CASE(lines_light_what_their_points_light)
{
    const Vec3 ends[][2] = {
        {{-8, -5, 20}, {7, 6, 60}}, {{-6, 5, -30}, {9, -4, -8}}, {{-40, 2, 500}, {5, -3, 6}}};
    for (int k = 0; k < 2 * int(std::size(sheets)); ++k)
        for (const auto& end : ends) {
            const auto& s = sheets[k / 2];
            WireframeRequest request = request_of(sheet_of(s.arrangement, s.slant),
                                                  LensModel::extended_pinhole);
            request.pseudoscopic = k % 2;
            if (request.pseudoscopic && end[0].z < 0)
                continue; // nothing is recorded of it
            request.mesh.vertices = {end[0], end[1]};
            request.mesh.lines = {{{0, 1}, {Colour{1, 1, 1, 1}, Colour{1, 1, 1, 1}}}};
            const Pixels line = lit(drawn(request));
            // The pixels that points of the line light are the line's pixels or touch them, and
            // each pixel of the line touches one of theirs.
            WireframeRequest points = request;
            points.mesh.lines.clear();
            points.mesh.vertices.clear();
            const int count = 6000;
            for (int k = 0; k <= count; ++k) {
                points.mesh.vertices.push_back(end[0] + double(k) / count * (end[1] - end[0]));
                points.mesh.points.push_back({std::uint32_t(k), {1, 1, 1, 1}});
            }
            const Pixels dots = lit(drawn(points));
            const auto far_from = [](const Pixels& of, const Pixels& others) {
                int far = 0;
                for (const auto& [x, y] : of) {
                    bool touches = false;
                    for (int dy = -1; dy <= 1; ++dy)
                        for (int dx = -1; dx <= 1; ++dx)
                            touches = touches || others.count({x + dx, y + dy});
                    far += !touches;
                }
                return far;
            };
            BOOST_TEST(line.size() > 100u);
            // A few may not: a lens's border may cut off the pixel that would touch another.
            BOOST_TEST(far_from(line, dots) <= int(line.size() / 50));
            BOOST_TEST(far_from(dots, line) <= int(dots.size() / 50));
        }
}

BOOST_AUTO_TEST_CASE(faces_light_the_pixels_whose_rays_meet_them)
{
    const Vec3 corner[] = {{-3, -2, 8}, {2, -1, 16}, {-1, 3, 24}};
    const auto is_inside = [&](const BeamRay& ray) {
        double sign = 0;
        for (int k = 0; k < 3; ++k) {
            const Vec3 a = corner[k] - ray.point, b = corner[(k + 1) % 3] - ray.point;
            const double side = dot(ray.direction, cross(a, b));
            if (side * sign < 0)
                return false;
            sign = side;
        }
        return true;
    };
    for (const auto& s : sheets)
        for (int k = 0; k < 8; ++k) {
            const LensModel model = all_models[k / 2];
            WireframeRequest request = request_of(sheet_of(s.arrangement, s.slant), model, 150);
            request.film.width = 90;
            request.film.height = 70;
            request.samples = 3;
            request.faces = FaceStyle::flat;
            request.pseudoscopic = k % 2;
            request.mesh.vertices.assign(corner, corner + 3);
            request.mesh.triangles = {{{0, 1, 2}, {1, 1, 1, 1}}};
            Pixels want;
            for (int y = 0; y < request.film.height; ++y)
                for (int x = 0; x < request.film.width; ++x) {
                    Vec2 film = film_from_pixel(request.film, {x + 0.5, y + 0.5});
                    const auto owner = request.optics.map(film, request.mapping).ray;
                    if (!owner)
                        continue;
                    if (request.pseudoscopic)
                        film = mirrored_in_lens(request.optics, film, owner->lens);
                    for (const RayBundle& bundle : bundles_of(request.optics, request.samples))
                        for (const SharpPicture& picture : bundle.pictures) {
                            const auto ray = beam_ray(request.optics, film, owner->lens,
                                                      picture.through);
                            if (ray && is_inside(*ray))
                                want.insert({x, y});
                        }
                }
            BOOST_TEST(want.size() > 20u);
            BOOST_TEST((lit(drawn(request)) == want), name_of(model) << " " << k);
        }
}

BOOST_AUTO_TEST_CASE(near_points_cover_their_lens_but_not_a_pinhole)
{
    const Vec3 point{0.3, 0.05, 1};
    for (const auto& s : sheets) {
        const auto request = request_of(sheet_of(s.arrangement, s.slant),
                                        LensModel::extended_pinhole);
        const LensIndex own = request.optics.lattice().nearest({point.x, point.y});
        const LensPixels pixels(request.optics, request.film, request.mapping, {}, 1);
        const Pixels covered = lit(drawn(with_point(request, point)));
        std::size_t of_lens = 0, rows = 0;
        for (int k = 0; k < pixels.count(); ++k)
            if (pixels.lens(k) == own)
                for (const LensRun* run = pixels.begin(k); run != pixels.end(k); ++run) {
                    const bool hit = covered.count({run->first, run->row}) != 0;
                    rows += hit;
                    of_lens += hit ? std::size_t(run->end - run->first) : 0;
                }
        BOOST_TEST(covered.size() == of_lens);
        BOOST_TEST(rows == (s.arrangement == Arrangement::lenticular ? 1u : rows));
        BOOST_TEST(covered.size() >= 13u);
        const auto pinhole = request_of(sheet_of(s.arrangement, s.slant), LensModel::pinhole);
        BOOST_TEST(lit(drawn(with_point(pinhole, point))).size() <= 1u);
    }
}

BOOST_AUTO_TEST_CASE(models_spread_a_point_and_keep_its_light)
{
    const Vec3 point{0.3, 0.1, 60};
    const LensSheet sheet = sheet_of(Arrangement::lenticular);
    const Image sharp = drawn(
        with_point(request_of(sheet, LensModel::extended_pinhole, 1200), point));
    for (const LensModel model : {LensModel::hybrid, LensModel::full}) {
        auto request = with_point(request_of(sheet, model, 1200), point);
        request.samples = 64;
        const Image spread = drawn(request);
        BOOST_TEST(lit(spread).size() > 3 * lit(sharp).size());
        // Light at the margin of a spot may miss the lens's pixels, so that the outermost lenses
        // lose light; the others do not.
        BOOST_TEST(std::fabs(sum(spread) / sum(sharp) - 1) < 0.1);
        double weights = 0;
        for (const RayBundle& bundle : bundles_of(request.optics, request.samples))
            for (const SharpPicture& picture : bundle.pictures)
                weights += picture.weight;
        BOOST_TEST(std::fabs(weights - 1) < 1e-12);
    }
    // hybrid: brightest in the middle, I(1) = cos(atan 4) at the marginal rays
    const auto bundle = bundles_of(
        SheetOptics(sheet, *filling_aperture(sheet, 300), LensModel::hybrid), 1001)[0];
    BOOST_TEST(bundle.rays.size() == 3u);
    const double ratio = bundle.pictures.front().weight / bundle.pictures[500].weight;
    BOOST_TEST(std::fabs(ratio - std::cos(std::atan(4.0))) < 1e-3);
}

BOOST_AUTO_TEST_CASE(lines_that_cross_the_sheet_are_lost_by_pinholes_alone)
{
    for (const LensModel model :
         {LensModel::pinhole, LensModel::extended_pinhole, LensModel::hybrid, LensModel::full}) {
        WireframeRequest request = request_of(sheet_of(Arrangement::lenticular), model, 600);
        const Colour white{1, 1, 1, 1};
        request.mesh.vertices = {{-4.3, -2, -9}, {4.7, 2, 9}};
        request.mesh.lines = {{{0, 1}, {white, white}}};
        const Pixels line = lit(drawn(request));
        std::set<std::int64_t> lenses;
        for (const auto& [x, y] : line)
            lenses.insert(
                request.optics
                    .map(film_from_pixel(request.film, {x + 0.5, y + 0.5}), request.mapping)
                    .ray->lens.i);
        const bool gap = lenses.count(0) == 0; // it crosses lens 0, pole at 0.2, at x = 0.2
        BOOST_TEST(gap == (model == LensModel::pinhole));
        BOOST_TEST(lenses.count(-1) + lenses.count(1) == 2u);
    }
}

BOOST_AUTO_TEST_CASE(faces_hide_what_is_behind_them)
{
    for (const auto& s : sheets)
        for (const LensModel model : {LensModel::extended_pinhole, LensModel::full}) {
            WireframeRequest request = request_of(sheet_of(s.arrangement, s.slant), model);
            request.samples = 5;
            request.faces = FaceStyle::hidden;
            request.mesh.vertices = {{-5, 0, 30},    {5, 1, 30},    {-5, 1, 10}, {5, 2, 10},
                                     {-90, -90, 20}, {90, -90, 20}, {0, 120, 20}};
            const Colour white{1, 1, 1, 1};
            request.mesh.triangles = {{{4, 5, 6}, white}};
            request.mesh.lines = {{{0, 1}, {white, white}}};
            BOOST_TEST(lit(drawn(request)).empty());
            request.mesh.lines = {{{2, 3}, {white, white}}};
            const Image in_front = drawn(request);
            request.mesh.triangles.clear();
            BOOST_TEST((lit(drawn(request)) == lit(in_front)));
            BOOST_TEST(!lit(in_front).empty());
        }
}

BOOST_AUTO_TEST_CASE(faces_are_what_pixels_rays_meet)
{
    const Vec3 corner[] = {{-6, -4, -20}, {7, -2, 35}, {-1, 6, 15}}; // it crosses the sheet
    for (const auto& s : sheets) {
        WireframeRequest request = request_of(sheet_of(s.arrangement, s.slant),
                                              LensModel::extended_pinhole);
        request.faces = FaceStyle::flat;
        request.mesh.vertices.assign(corner, corner + 3);
        request.mesh.triangles = {{{0, 1, 2}, {1, 1, 1, 1}}};
        const Pixels face = lit(drawn(request));
        int wrong = 0;
        for (int y = 0; y < request.film.height; ++y)
            for (int x = 0; x < request.film.width; ++x) {
                const auto ray = request.optics
                                     .map(film_from_pixel(request.film, {x + 0.5, y + 0.5}),
                                          request.mapping)
                                     .ray;
                bool hit = false;
                if (ray) { // on the same side of the three planes through the ray and a side
                    const Vec3 from{ray->pole.x, ray->pole.y, 0};
                    double side[3];
                    for (int k = 0; k < 3; ++k)
                        side[k] = dot(ray->direction,
                                      cross(corner[k] - from, corner[(k + 1) % 3] - from));
                    hit = (side[0] > 0 && side[1] > 0 && side[2] > 0) ||
                          (side[0] < 0 && side[1] < 0 && side[2] < 0);
                }
                wrong += hit != (face.count({x, y}) != 0);
            }
        BOOST_TEST(face.size() > 1000u);
        BOOST_TEST(wrong == 0);
    }
}

BOOST_AUTO_TEST_CASE(flat_faces_are_lit_from_the_side_that_the_eye_sees)
{
    // In both orders of the corners, light from the viewer's side lights the face, and light from
    // behind leaves the ambient fifth.
    for (const bool turned : {false, true})
        for (const double light : {-1.0, 1.0}) {
            auto request = request_of(sheet_of(Arrangement::lenticular),
                                      LensModel::extended_pinhole);
            request.faces = FaceStyle::flat;
            request.light = {0, 0, light};
            request.mesh.vertices = {{-9, -9, 20}, {9, -9, 20}, {0, 9, 20}};
            request.mesh.triangles = {{{0, 1, 2}, {1, 1, 1, 1}}};
            if (turned)
                std::swap(request.mesh.triangles[0].vertex[1],
                          request.mesh.triangles[0].vertex[2]);
            const Image image = drawn(request);
            const Pixels pixels = lit(image);
            BOOST_REQUIRE(pixels.size() > 1000u);
            for (const auto& [x, y] : pixels)
                BOOST_TEST(std::fabs(stored_pixel(image, x, y).r - (light < 0 ? 1 : 0.2)) < 1e-6);
        }
}

BOOST_AUTO_TEST_CASE(pseudoscopic_mirrors_what_is_behind)
{
    for (const auto& s : sheets) {
        auto request = request_of(sheet_of(s.arrangement, s.slant), LensModel::extended_pinhole);
        request.pseudoscopic = true;
        BOOST_TEST(lit(drawn(with_point(request, {0, 0, -20}))).empty());
        const Vec3 point{0.4, 0.3, 20};
        WireframeCost cost;
        draw_wireframe(with_point(request, {0.4, 0.3, 6}), 32, 1, {}, cost);
        BOOST_TEST(cost.projections > 0);
        BOOST_TEST(cost.projections < 0.75 * cost.lenses); // no lens that cannot image it
        const Pixels pixels = lit(drawn(with_point(request, point)));
        BOOST_TEST(!pixels.empty());
        for (const auto& [x, y] : pixels) { // the mirrored pixel's ray goes near the point
            const Vec2 film = film_from_pixel(request.film, {x + 0.5, y + 0.5});
            const auto ray = request.optics.map(film, request.mapping).ray;
            BOOST_REQUIRE(ray.has_value());
            const auto back = request.optics.ray_through(
                mirrored_in_lens(request.optics, film, ray->lens), ray->lens);
            BOOST_REQUIRE(back.has_value());
            const Vec3 from{back->pole.x, back->pole.y, 0};
            const double pixel_at_point = 0.0847 * 1.6 / 3.08 * 20;
            BOOST_TEST(length(cross(point - from, back->direction)) < 1.1 * pixel_at_point);
        }
    }
}

BOOST_AUTO_TEST_CASE(the_report_gives_the_mean_number_of_lenses)
{
    Mesh mesh;
    mesh.vertices.resize(4);
    WireframeCost cost;
    cost.lenses = 100;
    cost.projections = 10;
    BOOST_TEST(drawing_text(mesh, cost, 0.5) ==
               "4 vertices through 2.5 of 100 lenses each: 10 projections, 0.50 s");
}

BOOST_AUTO_TEST_SUITE_END()
