// SPDX-License-Identifier: AGPL-3.0-or-later
// The rays of a pixel (append_rays): their number, where they start and leave the sheet, and the
// counts of film points without rays.
#include "tests/unit/optics_sheets.h"
#include "tests/unit/pixel_origins.h"

#include <algorithm>

using namespace pixel_origins;

BOOST_AUTO_TEST_SUITE(sampling_pixel_sampler)

BOOST_AUTO_TEST_CASE(numbers_of_rays)
{
    const struct {
        LensModel model;
        Subpixels subpixels;
        int pixel, beam;
        int lenticular, other;
    } cases[] = {{LensModel::extended_pinhole, Subpixels::none, 1, 1, 1, 1},
                 {LensModel::extended_pinhole, Subpixels::none, 5, 1, 5, 5},
                 {LensModel::extended_pinhole, Subpixels::none, 1, 7, 7, 7},
                 {LensModel::pinhole, Subpixels::none, 3, 4, 12, 12},
                 {LensModel::full, Subpixels::none, 2, 9, 18, 18},
                 {LensModel::hybrid, Subpixels::none, 1, 0, 3, 5},
                 {LensModel::hybrid, Subpixels::none, 4, 0, 12, 20},
                 {LensModel::extended_pinhole, Subpixels::rgb, 1, 1, 3, 3},
                 {LensModel::extended_pinhole, Subpixels::bgr, 3, 4, 36, 36},
                 {LensModel::hybrid, Subpixels::rgb, 2, 0, 18, 30}};
    for (const Arrangement arrangement : arrangements)
        for (const auto& c : cases) {
            CameraParameters p = parameters_of(arrangement, c.pixel);
            p.model = c.model;
            p.film.subpixels = c.subpixels;
            p.beam_samples.reset();
            if (c.beam > 0)
                p.beam_samples = c.beam;
            const IntegralCamera camera = camera_of(p, 40, 40);
            const PixelSampler sampler(camera, 1);
            const Vec2 centre{23.5, 18.5}; // 3 pixels from the pole of a lens
            BOOST_REQUIRE(whole(camera, centre));
            const auto rays = rays_at(sampler, centre);
            BOOST_TEST(rays.size() ==
                       unsigned(arrangement == Arrangement::lenticular ? c.lenticular : c.other));
            double weight[2] = {};
            for (const PixelRay& ray : rays)
                weight[ray.half] += ray.weight;
            const int channels = c.subpixels == Subpixels::none ? 1 : 3,
                      samples = c.pixel * std::max(1, c.beam);
            BOOST_TEST(weight[0] + weight[1] == channels * samples,
                       boost::test_tools::tolerance(1e-12));
            if (samples > 1)
                BOOST_TEST(weight[0] == channels * (samples / 2),
                           boost::test_tools::tolerance(1e-12));
            BOOST_TEST(sampler.halves_tell_error() == (c.pixel > 1 && c.beam > 1 && samples >= 16));
        }
}

BOOST_AUTO_TEST_CASE(one_sample_is_the_pole_ray)
{
    for (const Arrangement arrangement : arrangements)
        for (const LensModel model :
             {LensModel::pinhole, LensModel::extended_pinhole, LensModel::full})
            for (const Subpixels subpixels : {Subpixels::none, Subpixels::bgr}) {
                CameraParameters p = parameters_of(arrangement);
                p.model = model;
                p.film.subpixels = subpixels;
                const IntegralCamera camera = camera_of(p, 60, 40);
                const PixelSampler sampler(camera, 3);
                int rays_seen = 0;
                for_each_pixel(camera, false, [&](Vec2 centre) {
                    std::vector<BeamRay> expected;
                    for (int channel = 0; channel < (subpixels == Subpixels::none ? 1 : 3);
                         ++channel) {
                        const Vec2 at = centre + subpixel_shift(subpixels, centre, channel);
                        const MappedPoint mapped = camera.optics.map(
                            film_from_pixel(camera.film, at), camera.mapping);
                        if (mapped.ray)
                            expected.push_back(pole_beam(*mapped.ray));
                    }
                    const auto rays = rays_at(sampler, centre);
                    BOOST_REQUIRE(rays.size() == expected.size());
                    const double error = model == LensModel::full ? 1e-12 : 0;
                    for (std::size_t i = 0; i < rays.size(); ++i) {
                        BOOST_TEST(length(rays[i].ray.direction - expected[i].direction) <= error);
                        BOOST_TEST(length(rays[i].ray.point - expected[i].point) <= error);
                        BOOST_TEST(length(rays[i].ray.aperture_point -
                                          expected[i].aperture_point) <= 1000 * error);
                        ++rays_seen;
                    }
                });
                BOOST_TEST(rays_seen > 2000);
            }
}

BOOST_AUTO_TEST_CASE(samples_lie_in_the_pixel_and_in_the_cell_of_its_lens)
{
    for (const Arrangement arrangement : arrangements)
        for (const LensModel model : {LensModel::extended_pinhole, LensModel::full})
            for (const double slant : {0.0, 12.0, 70.0}) {
                CameraParameters p = parameters_of(arrangement, 3, 4);
                p.model = model;
                p.sheet.slant = slant;
                p.film.subpixels = slant == 12 ? Subpixels::rgb : Subpixels::none;
                const IntegralCamera camera = camera_of(p, 70, 50);
                const PixelSampler sampler(camera, 5);
                Vec2 far_film, far_lens;
                for_each_pixel(camera, false, [&](Vec2 centre) {
                    const auto rays = rays_at(sampler, centre);
                    for (const PixelRay& ray : rays) {
                        const double shift = ray.channel < 0 ? 0
                                                             : subpixel_shift(p.film.subpixels,
                                                                              centre, ray.channel)
                                                                   .x;
                        const Vec2 own{centre.x + shift, centre.y};
                        const LensIndex lens = lens_at(camera, own);
                        const Origin at = origin_of(camera, own, ray.ray, lens);
                        BOOST_TEST(std::fabs(at.film.x) <=
                                   (ray.channel < 0 ? 0.5 : 1 / 6.0) + 1e-9);
                        BOOST_TEST(std::fabs(at.film.y) <= 0.5 + 1e-9);
                        BOOST_TEST(std::fabs(at.lens.x) <= 0.5 + 1e-9);
                        const Vec2 leaves{ray.ray.point.x, ray.ray.point.y};
                        const Lattice& lattice = camera.optics.lattice();
                        BOOST_TEST(lattice.distance(leaves, lens) <
                                   lattice.distance(leaves, lattice.nearest(leaves)) + 1e-9);
                        // ... and the pole ray of its film point passes the aperture through that
                        // lens.
                        const auto mapped = camera.optics.map(
                            film_from_pixel(camera.film, own + at.film), camera.mapping);
                        BOOST_TEST((mapped.ray && mapped.ray->lens == lens));
                        far_film = {std::max(far_film.x, std::fabs(at.film.x)),
                                    std::max(far_film.y, std::fabs(at.film.y))};
                        far_lens.x = std::max(far_lens.x, std::fabs(at.lens.x));
                    }
                });
                // Samples fill the whole pixel and the whole cell.
                BOOST_TEST(far_film.x > (slant == 12 ? 0.16 : 0.49));
                BOOST_TEST(far_film.y > 0.49);
                BOOST_TEST(far_lens.x > 0.49);
            }
}

BOOST_AUTO_TEST_CASE(a_pixel_on_a_border_is_its_own_lens_s_and_never_lost)
{
    for (const Arrangement arrangement : {Arrangement::square, Arrangement::lenticular})
        for (const int samples : {2, 3, 64}) {
            CameraParameters p = parameters_of(arrangement, samples);
            p.sheet.slant = 8;
            // Two of three samples lie on opposite sides of the centre, so all three seldom belong
            // to another lens. A larger film then has enough such pixels.
            const IntegralCamera camera = samples == 3 ? camera_of(p, 500, 400)
                                                       : camera_of(p, 90, 70);
            const PixelSampler sampler(camera, 2);
            int at_centre = 0, fewer = 0;
            double kept = 0, expected = 0;
            for_each_pixel(camera, false, [&](Vec2 centre) {
                std::vector<PixelRay> rays;
                const PixelOutcome outcome = sampler.append_rays(centre, rays);
                const MappedPoint mapped = camera.optics.map(film_from_pixel(camera.film, centre),
                                                             camera.mapping);
                BOOST_TEST(outcome.imaged == int(mapped.ray.has_value()));
                BOOST_TEST(rays.empty() != mapped.ray.has_value());
                if (rays.empty() || whole(camera, centre))
                    return;
                const auto list = origins(camera, centre, rays);
                at_centre += length(list[0].film) < 1e-9;
                fewer += rays.size() < unsigned(samples);
                kept += rays.size();
                for (int k = 0; k < 256; ++k) { // fraction of the area imaged by its lens
                    const Vec2 at{centre.x + (k % 16 - 7.5) / 16, centre.y + (k / 16 - 7.5) / 16};
                    const MappedPoint there = camera.optics.map(film_from_pixel(camera.film, at),
                                                                camera.mapping);
                    expected += there.ray && there.ray->lens == mapped.ray->lens ? samples / 256.0
                                                                                 : 0;
                }
            });
            BOOST_TEST(fewer > 100);
            BOOST_TEST((at_centre > 0) == (samples < 64)); // if all are another's: the centre
            if (samples == 64)
                BOOST_TEST(std::fabs(kept / expected - 1) < 0.01);
        }
}

BOOST_AUTO_TEST_CASE(seed_and_pixel_alone_decide)
{
    const IntegralCamera camera = camera_of(parameters_of(Arrangement::hexagonal, 2, 2));
    const PixelSampler one(camera, 1), again(camera, 1), other(camera, 2);
    const auto places = [&](const PixelSampler& sampler, Vec2 centre, bool random) {
        std::vector<double> list;
        for (const PixelRay& ray :
             random ? random_rays_at(sampler, centre, 4) : rays_at(sampler, centre)) {
            const Vec2 from = Vec2{ray.ray.point.x, ray.ray.point.y} -
                              camera.optics.lattice().pole(lens_at(camera, centre));
            list.insert(list.end(), {from.x, from.y});
        }
        return list;
    };
    for (const bool random : {false, true}) {
        std::vector<std::vector<double>> seen;
        for (const Vec2 centre : {Vec2{70.5, 60.5}, Vec2{71.5, 60.5}, Vec2{70.5, 61.5},
                                  Vec2{60.5, 70.5}, Vec2{70.25, 60.5}}) {
            BOOST_CHECK(places(one, centre, random) == places(again, centre, random));
            BOOST_CHECK(places(one, centre, random) == places(one, centre, random));
            seen.push_back(places(one, centre, random));
            seen.push_back(places(other, centre, random));
        }
        for (std::size_t i = 0; i < seen.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                for (std::size_t k = 0; k < std::min(seen[i].size(), seen[j].size()); ++k)
                    BOOST_TEST(std::fabs(seen[i][k] - seen[j][k]) > 1e-9);
    }
    BOOST_TEST(random_bits(1, 2) == random_bits(1, 2));
    BOOST_TEST(random_bits(1, 2) != random_bits(2, 1));
}

BOOST_AUTO_TEST_CASE(pseudoscopic_rays_go_the_mirrored_way)
{
    for (const Arrangement arrangement : arrangements)
        for (const LensModel model : {LensModel::extended_pinhole, LensModel::full}) {
            CameraParameters p = parameters_of(arrangement);
            p.sheet.slant = arrangement == Arrangement::lenticular ? 0 : 17;
            p.model = model;
            p.beam_samples = 1;
            const IntegralCamera straight = camera_of(p, 70, 50);
            p.pseudoscopic = true;
            const IntegralCamera mirrored = camera_of(p, 70, 50);
            p.pixel_samples = p.beam_samples.emplace(4);
            const IntegralCamera sampled = camera_of(p, 70, 50);
            const PixelSampler plain(straight, 1), turned(mirrored, 1), many(sampled, 1);
            int judged = 0;
            for_each_pixel(straight, false, [&](Vec2 centre) {
                const auto before = rays_at(plain, centre), after = rays_at(turned, centre);
                BOOST_REQUIRE(before.size() == after.size());
                if (before.empty())
                    return;
                const LensIndex lens = lens_at(straight, centre);
                const Vec2 film_point = film_from_pixel(straight.film, centre);
                const Vec2 other = mirrored_in_lens(straight.optics, film_point, lens);
                BOOST_TEST(length(mirrored_in_lens(straight.optics, other, lens) - film_point) <
                           1e-12);
                // the sideways part turns round; on a lenticular sheet only the part across the
                // lens does
                const double along = arrangement == Arrangement::lenticular ? 1 : -1;
                const Vec3 d = before[0].ray.direction, turned_round{-d.x, along * d.y, d.z};
                BOOST_TEST(length(after[0].ray.direction - turned_round) < 1e-12);
                BOOST_TEST(length(after[0].ray.point - before[0].ray.point) < 1e-12);
                for (const PixelRay& ray : rays_at(many, centre)) {
                    const Origin at = origin_of(sampled, pixel_from_film(sampled.film, other),
                                                ray.ray, lens);
                    BOOST_TEST(
                        (std::fabs(at.film.x) <= 0.5 + 1e-9 && std::fabs(at.film.y) <= 0.5 + 1e-9));
                    ++judged;
                }
            });
            BOOST_TEST(judged > 30000);
        }
}

BOOST_AUTO_TEST_CASE(what_becomes_of_film_points_adds_up)
{
    random_sheets::Generator random(31);
    int cameras = 0, fell_short = 0, reflected = 0, outside = 0, searched = 0;
    for (int trial = 0; trial < random_sheets::count(1500, 100000); ++trial) {
        CameraParameters p;
        p.sheet = random.sheet();
        p.model = LensModel(trial % 4);
        p.mapping = LensMapping(trial / 4 % 3);
        if (refracts_at_surface(p.model)) { // steep at the edge, for total reflection
            p.sheet.ior = random.between(1.3, 4);
            p.sheet.thickness = cell_circumradius(p.sheet) * random.between(1, 1.5) * p.sheet.ior /
                                (p.sheet.ior - 1);
        }
        p.film.units_per_mm = 1;
        p.film.subpixels = random.one_in(3) ? Subpixels::bgr : Subpixels::none;
        p.film.pixel_pitch = {p.sheet.pitch * random.log_between(0.01, 3),
                              p.sheet.pitch * random.log_between(0.01, 3)};
        p.pixel_samples = random.one_in(2) ? 1 : 5;
        if (p.model != LensModel::hybrid)
            p.beam_samples = random.one_in(2) ? 1 : 3;
        p.pseudoscopic = random.one_in(4);
        const double d = p.sheet.thickness * random.log_between(1, 1e4),
                     w = d * random.log_between(0.01, 20);
        p.capture_aperture = Vec2{w, w};
        ViewFrame view;
        view.direction = {0, 0, d};
        view.right = {1, 0, 0};
        view.up = {0, 1, 0};
        std::optional<IntegralCamera> camera;
        try {
            camera = make_camera(p, view, 25, 15);
        } catch (const std::invalid_argument&) {
            continue; // a lens without a surface, for hybrid and full
        }
        ++cameras;
        const PixelSampler sampler(*camera, trial);
        const std::size_t most = *p.pixel_samples *
                                 (p.model == LensModel::hybrid ? 5 : *p.beam_samples);
        std::vector<PixelRay> rays;
        for_each_pixel(*camera, false, [&](Vec2 centre) {
            rays.clear();
            const PixelOutcome o = sampler.append_rays(centre, rays);
            const int points = p.film.subpixels == Subpixels::none ? 1 : 3;
            const bool adds_up = o.film_points == points &&
                                 o.imaged + o.outside_aperture + o.total_reflection == points &&
                                 o.searched <= o.imaged && (o.imaged > 0) == !rays.empty() &&
                                 rays.size() <= o.imaged * most && o.imaged >= 0 &&
                                 o.outside_aperture >= 0 && o.total_reflection >= 0;
            BOOST_TEST(adds_up, p.sheet << " model " << int(p.model) << " pixel " << centre.x << ','
                                        << centre.y);
            fell_short += o.imaged > 0 && p.pixel_samples == 1 && p.model == LensModel::full &&
                          rays.size() < o.imaged * most;
            reflected += o.total_reflection;
            outside += o.outside_aperture;
            searched += o.searched;
            // If the ray of the pixel's centre exists, random rays are found, too.
            const bool found = sampler.append_reference_ray(centre, 0, 0, rays);
            BOOST_TEST((found || o.imaged == 0 || p.model == LensModel::full ||
                        p.model == LensModel::hybrid));
            for (const PixelRay& ray : rays) {
                const double sum = length(ray.ray.point) + length(ray.ray.aperture_point) +
                                   ray.weight;
                BOOST_TEST(std::isfinite(sum));
                BOOST_TEST(
                    (std::fabs(length(ray.ray.direction) - 1) < 1e-9 && ray.ray.direction.z < 0));
            }
        });
    }
    BOOST_TEST_MESSAGE(cameras << " cameras; points with rays totally reflected " << fell_short
                               << ", without any " << reflected << ", outside " << outside
                               << ", searched " << searched);
    BOOST_TEST(cameras > 300);
    BOOST_TEST(fell_short > 1000);
    BOOST_TEST(reflected > 1000);
    BOOST_TEST(outside > 1000);
    BOOST_TEST(searched > 1000);
}

BOOST_AUTO_TEST_SUITE_END()
