// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests wireframes of many things that are smaller than a pixel, which are drawn in another way
// than large ones: compares with the ray of every pixel and with the projection of every point.
#include "integral/wireframe/film_loops.h"
#include "integral/wireframe/wireframe.h"

#include "integral/optics/beam.h"

#include <boost/test/unit_test.hpp>

#include <map>
#include <random>

using namespace integral;

namespace {

const struct {
    Arrangement arrangement;
    double slant;
    bool pseudoscopic;
} cases[] = {{Arrangement::square, 0, false},
             {Arrangement::square, 20, true},
             {Arrangement::hexagonal, -8, false}};

class Random {
public:
    double between(double a, double b)
    {
        return std::uniform_real_distribution<double>(a, b)(engine_);
    }
    Vec3 place(bool only_behind)
    {
        const double z = only_behind || between(0, 1) < 0.6 ? between(5, 60) : between(-50, -5);
        return {between(-5, 5), between(-4, 4), z};
    }

private:
    std::mt19937 engine_{7};
};

WireframeRequest request_of(Arrangement arrangement, double slant, bool pseudoscopic)
{
    LensSheet sheet;
    sheet.arrangement = arrangement;
    sheet.slant = slant;
    WireframeRequest request{{},
                             SheetOptics(sheet, *filling_aperture(sheet, 300)),
                             Film{120, 90, {25.4 / 300, 25.4 / 300}}};
    request.pseudoscopic = pseudoscopic;
    return request;
}

Image drawn(const WireframeRequest& request, WireframeCost& cost)
{
    const auto image = draw_wireframe(request, 32, 1, {}, cost);
    BOOST_REQUIRE(image.has_value());
    return *image;
}

/// The colour of the thing with that number, and the number that a pixel's colour stands for; 0 is
/// the background.
Colour colour_of(int number) { return {float(number), 0, 0, 1}; }
int number_at(const Image& image, int x, int y) { return int(stored_pixel(image, x, y).r + 0.5f); }

std::optional<double> depth_on(const std::array<Vec3, 3>& corner, const BeamRay& ray)
{
    // Where the ray meets the plane, and whether all three sides have it on the same side.
    const Vec3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
    const double way = dot(normal, corner[0] - ray.point) / dot(normal, ray.direction);
    const Vec3 at = ray.point + way * ray.direction;
    for (int k = 0; k < 3; ++k)
        if (dot(normal, cross(corner[(k + 1) % 3] - corner[k], at - corner[k])) < 0)
            return std::nullopt;
    return at.z;
}

} // namespace

BOOST_AUTO_TEST_SUITE(wireframe_far)

BOOST_AUTO_TEST_CASE(points_projected_together_are_where_the_ray_tracer_has_them)
{
    Random random;
    for (const auto& c : cases) {
        const auto request = request_of(c.arrangement, c.slant, c.pseudoscopic);
        const SheetOptics& optics = request.optics;
        for (const LensIndex lens : {LensIndex{0, 0}, LensIndex{3, -2}, LensIndex{-40, 25}}) {
            const Vec2 pole = optics.lattice().pole(lens);
            const PoleView view{
                optics.medium(), pole, c.pseudoscopic, request.film, {0.3, 0}, 1, 2, 15, 14, 17};
            FilmChunk chunk;
            for (int k = 0; k < FilmChunk::most; ++k) {
                const double far = std::pow(10, random.between(-1, 4));
                const Vec3 at = random.place(false);
                chunk.x[k] = far * at.x;
                chunk.y[k] = far * at.y;
                chunk.z[k] = std::max(far, -5.0 / at.z) * at.z;
            }
            project(view, chunk);
            for (int k = 0; k < FilmChunk::most; ++k) {
                const Vec3 point{chunk.x[k], chunk.y[k], chunk.z[k]};
                Vec2 film = film_from_pixel(request.film,
                                            Vec2{chunk.across[k], chunk.down[k]} + view.shift);
                if (c.pseudoscopic)
                    film = mirrored_in_lens(optics, film, lens);
                const auto ray = optics.ray_through(film, lens);
                const auto exact = film_point_imaging(optics, point, lens);
                BOOST_REQUIRE(exact.has_value());
                BOOST_TEST(length(film - *exact) <= 1e-11);
                if (ray && length(point) < 100)
                    BOOST_TEST(length(cross(point - Vec3{pole.x, pole.y, 0}, ray->direction)) <=
                               1e-9);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(of_small_faces_each_pixel_shows_the_nearest_on_its_ray)
{
    Random random;
    for (const auto& c : cases) {
        WireframeRequest request = request_of(c.arrangement, c.slant, c.pseudoscopic);
        request.faces = FaceStyle::flat;
        std::vector<std::array<Vec3, 3>> faces;
        for (int k = 0; k < 300; ++k) {
            const Vec3 middle = random.place(c.pseudoscopic);
            const double pixel = std::fabs(middle.z) * 1.6 / 3.08 * 25.4 / 300,
                         size = pixel * random.between(0.1, 4);
            std::array<Vec3, 3> corner;
            for (Vec3& at : corner)
                at = middle + Vec3{size * random.between(-1, 1), size * random.between(-1, 1),
                                   random.between(-1, 1)};
            faces.push_back(corner);
        }
        for (std::size_t k = 0; k < faces.size(); ++k) {
            const auto v = std::uint32_t(request.mesh.vertices.size());
            request.mesh.vertices.insert(request.mesh.vertices.end(), faces[k].begin(),
                                         faces[k].end());
            // Lit from the viewer's side, whichever way it faces: at least by the ambient fifth.
            request.mesh.triangles.push_back({{v, v + 1, v + 2}, {1, float(k + 1), 0, 1}});
        }
        WireframeCost cost;
        const Image image = drawn(request, cost);
        int wrong = 0, shown = 0;
        for (int y = 0; y < request.film.height; ++y)
            for (int x = 0; x < request.film.width; ++x) {
                Vec2 film = film_from_pixel(request.film, {x + 0.5, y + 0.5});
                const auto owner = request.optics.map(film, request.mapping).ray;
                std::size_t nearest = 0; // 1 for the first face
                double depth = 1e300;
                if (owner) {
                    if (c.pseudoscopic)
                        film = mirrored_in_lens(request.optics, film, owner->lens);
                    const auto ray = beam_ray(request.optics, film, owner->lens, {});
                    BOOST_REQUIRE(ray.has_value());
                    for (std::size_t k = 0; k < faces.size(); ++k) {
                        const auto seen = depth_on(faces[k], *ray);
                        if (seen && *seen < depth) {
                            depth = *seen;
                            nearest = k + 1;
                        }
                    }
                }
                const Colour is = stored_pixel(image, x, y);
                const std::size_t number = is.r > 0 ? std::size_t(is.g / is.r + 0.5f) : 0;
                shown += nearest != 0;
                wrong += number != nearest;
            }
        BOOST_TEST(shown > 500);
        BOOST_TEST(wrong == 0);
    }
}

BOOST_AUTO_TEST_CASE(of_tiny_lines_each_pixel_shows_the_nearest)
{
    Random random;
    for (const auto& c : cases) {
        WireframeRequest request = request_of(c.arrangement, c.slant, c.pseudoscopic);
        std::vector<Vec3> places;
        for (int k = 0; k < 400; ++k) {
            const Vec3 at = random.place(c.pseudoscopic);
            const auto v = std::uint32_t(request.mesh.vertices.size());
            const Vec3 tiny{1e-7, 1e-7, 0};
            request.mesh.vertices.push_back(at - tiny);
            request.mesh.vertices.push_back(at + tiny);
            const Colour colour = colour_of(k + 1);
            request.mesh.lines.push_back({{v, v + 1}, {colour, colour}});
            places.push_back(at);
        }
        WireframeCost cost;
        const Image image = drawn(request, cost);
        // The expected pixels are found by trying every line through every lens.
        std::map<std::pair<int, int>, std::pair<double, int>> want; // pixel -> depth, number
        std::map<std::pair<std::int64_t, std::int64_t>, LensIndex> lenses;
        const auto lens_of = [&](int x, int y) {
            return request.optics
                .map(film_from_pixel(request.film, {x + 0.5, y + 0.5}), request.mapping)
                .ray;
        };
        for (int y = 0; y < request.film.height; ++y)
            for (int x = 0; x < request.film.width; ++x)
                if (const auto ray = lens_of(x, y))
                    lenses[{ray->lens.i, ray->lens.j}] = ray->lens;
        for (const auto& [key, lens] : lenses)
            for (std::size_t k = 0; k < places.size(); ++k) {
                auto film = *film_point_imaging(request.optics, places[k], lens);
                if (c.pseudoscopic)
                    film = mirrored_in_lens(request.optics, film, lens);
                const Vec2 pixel = pixel_from_film(request.film, film);
                const int x = int(std::floor(pixel.x)), y = int(std::floor(pixel.y));
                if (x < 0 || y < 0 || x >= request.film.width || y >= request.film.height)
                    continue;
                const auto owner = lens_of(x, y);
                if (!owner || owner->lens != lens)
                    continue;
                const std::pair<double, int> here{places[k].z, int(k) + 1};
                const auto [at, is_new] = want.insert({{x, y}, here});
                if (!is_new && here < at->second)
                    at->second = here;
            }
        int wrong = 0;
        for (int y = 0; y < request.film.height; ++y)
            for (int x = 0; x < request.film.width; ++x) {
                const auto at = want.find({x, y});
                wrong += number_at(image, x, y) != (at == want.end() ? 0 : at->second.second);
            }
        BOOST_TEST(want.size() > 500u);
        BOOST_TEST(wrong == 0);
        // No vertex is projected through many more lenses than image it.
        BOOST_TEST(cost.projections < double(cost.lenses) * double(places.size()) * 2);
    }
}

BOOST_AUTO_TEST_CASE(a_line_in_pieces_is_the_line)
{
    for (const auto& c : cases) {
        WireframeRequest request = request_of(c.arrangement, c.slant, c.pseudoscopic);
        const Vec3 from{-4, -3, 12}, to{4, 2.5, 40};
        const auto lines = [&](int pieces) {
            request.mesh = {};
            for (int k = 0; k <= pieces; ++k)
                request.mesh.vertices.push_back(from + double(k) / pieces * (to - from));
            for (std::uint32_t k = 0; k < std::uint32_t(pieces); ++k)
                request.mesh.lines.push_back({{k, k + 1}, {colour_of(1), colour_of(1)}});
            WireframeCost cost;
            return drawn(request, cost);
        };
        const Image whole = lines(1), parts = lines(500);
        int lit = 0, apart = 0;
        for (int y = 0; y < whole.height; ++y)
            for (int x = 0; x < whole.width; ++x) {
                lit += number_at(whole, x, y);
                apart += number_at(whole, x, y) && !number_at(parts, x, y);
            }
        // A short piece lights every pixel that it enters; a line lights one in every column or
        // row.
        BOOST_TEST(lit > 300);
        BOOST_TEST(apart <= lit / 50);
    }
}

BOOST_AUTO_TEST_SUITE_END()
