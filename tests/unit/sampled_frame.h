// SPDX-License-Identifier: AGPL-3.0-or-later
// A small frame of a scene in closed form, sampled along the rays that PixelSampler chooses, and
// its reconstruction. True values are means over many random rays of a pixel.
#ifndef TESTS_UNIT_SAMPLED_FRAME_H
#define TESTS_UNIT_SAMPLED_FRAME_H

#include "integral/reconstruction/reconstruction.h"
#include "integral/reconstruction/refinement.h"
#include "integral/reconstruction/split_half_error.h"
#include "tests/unit/pixel_origins.h"

#include <cmath>
#include <functional>

namespace sampled_frame {

using namespace pixel_origins;

constexpr int width = 48, height = 44;

/// The hit of a ray: a grey value in linear light, its depth, and the tilt of the surface
/// (BeamSamples::Seen::tilt).
struct Look {
    double grey, depth;
    std::array<float, 2> tilt{};
};
using Scene = std::function<Look(const BeamRay&)>;

inline Vec2 place_at(const BeamRay& ray, double depth)
{
    const double way = (depth - ray.point.z) / ray.direction.z;
    return {ray.point.x + way * ray.direction.x, ray.point.y + way * ray.direction.y};
}

/// Squares of two grey values on a plane that leans: its depth grows by `rise` for each mm to the
/// right.
inline Scene chequers(double depth, double side, double rise = 0)
{
    return [=](const BeamRay& ray) {
        const double slope = ray.direction.x / ray.direction.z;
        const double z = (depth + rise * (ray.point.x - ray.point.z * slope)) / (1 - rise * slope);
        const Vec2 place = place_at(ray, z);
        const auto square = [&](double x) { return int(std::floor(x / side)) & 1; };
        return Look{square(place.x) == square(place.y) ? 0.7 : 0.1, z};
    };
}

/// A floor up to depth `edge`, and `beyond` behind it. `upper` and `lower`: the grey values of its
/// sides. `tells`: whether hits have the floor's tilt. `height`: mm above the frame's middle.
inline Scene floor_up_to(double edge, Look beyond, double upper, double lower, bool tells = true,
                         double height = -0.2)
{
    return [=](const BeamRay& ray) {
        const double slope = ray.direction.y / ray.direction.z,
                     depth = ray.point.z + (height - ray.point.y) / slope;
        if (!(depth > -290 && depth < edge))
            return beyond;
        return Look{slope < 0 ? upper : lower, depth, {0, tells ? float(1 / slope) : 0}};
    };
}

inline const TabulatedCurve encode([](float x) { return std::sqrt(std::fmax(0.0f, x)); });

/// A frame with `number` samples a pixel.
struct Sampled {
    IntegralCamera camera;
    PixelSampler sampler;
    LightFieldImage first;
    BeamSamples samples;
    Reconstruction reconstruction;
    std::vector<float> mean; ///< NaN for an empty pixel

    Sampled(const CameraParameters& parameters, const Scene& scene, int number,
            double least_error = 0.0005, std::uint64_t seed = 3)
        : camera(camera_of(parameters, width, height)),
          sampler(camera, seed),
          first(camera),
          samples(camera),
          reconstruction(camera, first, samples, least_error),
          mean(std::size_t(width) * height, NAN)
    {
        BeamSamples::Gathered gathered;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                take(x, y, scene, number, gathered);
        samples.store(0, gathered);
    }

    static std::size_t at(int x, int y) { return std::size_t(y) * width + x; }

    BeamSamples::Seen seen(const BeamRay& ray, const Look& look) const
    {
        const float grey = float(look.grey);
        return {light_field_ray(camera.optics.lattice(), ray),
                look.depth,
                {grey, grey, grey, 0},
                look.tilt};
    }

    void take(int x, int y, const Scene& scene, int number, BeamSamples::Gathered& gathered)
    {
        const Vec2 centre{x + 0.5, y + 0.5};
        const auto pole = camera.optics.map(film_from_pixel(camera.film, centre), camera.mapping)
                              .ray;
        if (!pole)
            return;
        const BeamRay ray = sampler.first_sample(centre, *pole, false);
        const Look look = scene(ray);
        samples.set_first(x, y, light_field_ray(camera.optics.lattice(), pole_beam(*pole)),
                          pole->lens, seen(ray, look));
        const auto compared = [](double grey) {
            const double value = encode(float(grey));
            return ComparedColour{value, value, value, 0};
        };
        first.set(x, y, compared(look.grey), pole->lens, look.depth);
        Refinement refinement({1, 0.1, 3}, 1.5);
        SplitHalfError halves;
        double sum = 0, taken = 0;
        const auto count = [&](float grey) {
            refinement.add(compared(grey));
            halves.add({grey, grey, grey, 0});
            sum += grey;
            ++taken;
        };
        count(float(look.grey));
        gathered.begin(x, y);
        const PixelBeam beam = sampler.beam(centre, false, look.depth);
        for (int index = 1; index < number; ++index) {
            std::vector<PixelRay> rays;
            sampler.append_sample(beam, index, rays);
            for (const PixelRay& more : rays) {
                const Look other = scene(more.ray);
                gathered.add(samples, seen(more.ray, other));
                count(float(other.grey));
            }
        }
        const double encoded = refinement.squared_deviations();
        put(x, y, float(sum / taken), refinement.squared_error(), halves.squared_error(encode),
            {number, int(taken)}, encoded > 0 ? halves.squared_deviations() / encoded : 0);
    }

    void put(int x, int y, float grey, double variance, double halves = -1,
             SamplesTaken samples = {}, double in_linear_light = 0)
    {
        mean[at(x, y)] = grey;
        reconstruction.set(x, y, {grey, grey, grey, 0}, variance, halves, samples, in_linear_light);
    }

    /// Extra samples of a scene; calls count(x, y, number) whenever some are taken.
    Reconstruction::ExtraSamples further(const Scene& scene, const RefinementRule& rule,
                                         std::function<void(int x, int y, int number)> count) const
    {
        return {rule, [=](int x, int y, int begin, int number, LinearColour& sum) {
                    count(x, y, number);
                    const Vec2 centre{x + 0.5, y + 0.5};
                    const PixelBeam beam = sampler.beam(centre, false, first.depth(x, y));
                    std::vector<PixelRay> rays;
                    for (int index = begin; index < begin + number; ++index)
                        sampler.append_sample(beam, index, rays);
                    for (const PixelRay& ray : rays)
                        for (int channel = 0; channel < 3; ++channel)
                            sum[channel] += float(scene(ray.ray).grey);
                    return int(rays.size());
                }};
    }

    static constexpr PictureBlock all{0, 0, width - 1, height - 1};

    /// `block`: the pixels from which the usual size of errors is estimated.
    std::vector<Reconstruction::Result> pixels(
        const PictureBlock& block = all, const Reconstruction::ExtraSamples* further = nullptr)
    {
        const auto scratch = Reconstruction::make_scratch();
        std::vector<Reconstruction::Result> result;
        reconstruction.estimate(all, block, *scratch);
        reconstruction.reconstruct(all, encode, *scratch, result, further);
        return result;
    }

    /// A pixel's converged light, approximately.
    double truth(const Scene& scene, int x, int y) const
    {
        double sum = 0;
        const auto rays = random_rays_at(sampler, {x + 0.5, y + 0.5}, 400);
        for (const PixelRay& ray : rays)
            sum += scene(ray.ray).grey / double(rays.size());
        return sum;
    }

    /// The RMS errors of some pixels, away from the frame's edge: before and after.
    std::array<double, 2> errors(const Scene& scene,
                                 const Reconstruction::ExtraSamples* further = nullptr)
    {
        const auto reconstructed = pixels(all, further);
        std::array<double, 2> sums{};
        int number = 0;
        for (int y = 14; y < height - 14; y += 2)
            for (int x = 14; x < width - 14; x += 3) {
                if (std::isnan(mean[at(x, y)]))
                    continue;
                const double right = truth(scene, x, y);
                const auto& light = reconstructed[at(x, y)];
                const auto square = [&](double grey) {
                    return std::pow(encode(float(grey)) - encode(float(right)), 2);
                };
                sums[0] += square(mean[at(x, y)]);
                sums[1] += square(light ? (*light)[1] : mean[at(x, y)]);
                ++number;
            }
        return {std::sqrt(sums[0] / number), std::sqrt(sums[1] / number)};
    }
};

inline CameraParameters sheet(Arrangement arrangement, double slant = 0)
{
    CameraParameters p = parameters_of(arrangement);
    p.sheet.slant = slant;
    p.film.pixel_pitch = {25.4 / 300, 25.4 / 300};
    return p;
}

/// The RMS error after the reconstruction, divided by the one before, over several frames with
/// different samples, because few pixels have most of a frame's error.
inline double ratio(const CameraParameters& parameters, const Scene& scene, int number)
{
    double before = 0, after = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const auto errors = Sampled(parameters, scene, number, 0.0005, seed).errors(scene);
        before += errors[0] * errors[0];
        after += errors[1] * errors[1];
    }
    return std::sqrt(after / before);
}

} // namespace sampled_frame

#endif
