// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds the film point and lens point of rays that a PixelSampler chooses, for its tests.
#ifndef TESTS_UNIT_PIXEL_ORIGINS_H
#define TESTS_UNIT_PIXEL_ORIGINS_H

#include "integral/sampling/pixel_sampler.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <functional>

namespace pixel_origins {

using namespace integral;

/// A sheet of 1.27 mm lenses seen from 300 mm, whose film has 12.7 x 10 pixels a lens.
inline CameraParameters parameters_of(Arrangement arrangement, int pixel_samples = 1,
                                      int beam_samples = 1)
{
    CameraParameters p;
    p.sheet = {arrangement, 1.27, 3.3, 1.6, 0, {0.031, -0.017}};
    p.film.pixel_pitch = {0.1, 0.127};
    p.film.units_per_mm = 1;
    p.pixel_samples = pixel_samples;
    p.beam_samples = beam_samples;
    return p;
}

inline IntegralCamera camera_of(const CameraParameters& p, int width = 150, int height = 120)
{
    ViewFrame view;
    view.location = {0, 0, -300};
    view.direction = {0, 0, 300};
    view.right = {1, 0, 0};
    view.up = {0, 1, 0};
    return make_camera(p, view, width, height);
}

inline std::vector<PixelRay> rays_at(const PixelSampler& sampler, Vec2 centre)
{
    std::vector<PixelRay> rays;
    sampler.append_rays(centre, rays);
    return rays;
}

inline std::vector<PixelRay> random_rays_at(const PixelSampler& sampler, Vec2 centre, int count)
{
    std::vector<PixelRay> rays;
    for (int index = 0; index < count; ++index)
        sampler.append_reference_ray(centre, index, 0, rays);
    return rays;
}

/// The origin of a ray, found by the inverse of the lens model: its film point in pixels from the
/// pixel's centre, its lens point in pitches from the pole (across and along the lattice's rows),
/// and the height at which it passes the slit.
struct Origin {
    Vec2 film, lens;
    double slit;
};

inline Origin origin_of(const IntegralCamera& camera, Vec2 centre, const BeamRay& ray,
                        LensIndex lens)
{
    const SheetOptics& optics = camera.optics;
    const Lattice& lattice = optics.lattice();
    Vec2 offset = Vec2{ray.point.x, ray.point.y} - lattice.pole(lens);
    LensPoint point{offset, 0};
    if (lattice.arrangement() == Arrangement::lenticular) {
        offset = dot(lattice.across(), offset) * lattice.across();
        const Vec2 slit = refracts_at_surface(optics.model()) ? ray.aperture_point
                                                              : ray.aperture_point - offset;
        point = {offset, slit_is_horizontal(optics.sheet()) ? slit.y : slit.x};
    }
    const auto film_point = film_point_imaging(optics, ray.point + (-50.0) * ray.direction, lens,
                                               point);
    BOOST_REQUIRE(film_point);
    const double p = lattice.pitch();
    return {pixel_from_film(camera.film, *film_point) - centre,
            {dot(lattice.across(), offset) / p, dot(lattice.along(), offset) / p},
            point.slit};
}

inline LensIndex lens_at(const IntegralCamera& camera, Vec2 centre)
{
    const MappedPoint mapped = camera.optics.map(film_from_pixel(camera.film, centre),
                                                 camera.mapping);
    BOOST_REQUIRE(mapped.ray);
    return mapped.ray->lens;
}

/// Origins of a pixel's rays.
inline std::vector<Origin> origins(const IntegralCamera& camera, Vec2 centre,
                                   const std::vector<PixelRay>& rays)
{
    std::vector<Origin> list;
    for (const PixelRay& ray : rays)
        list.push_back(origin_of(camera, centre, ray.ray, lens_at(camera, centre)));
    return list;
}

/// Whether all four corners of a pixel image something through the same lens.
inline bool whole(const IntegralCamera& camera, Vec2 centre)
{
    const MappedPoint middle = camera.optics.map(film_from_pixel(camera.film, centre),
                                                 camera.mapping);
    for (const Vec2 corner : {Vec2{-0.5, -0.5}, Vec2{-0.5, 0.5}, Vec2{0.5, -0.5}, Vec2{0.5, 0.5}}) {
        const MappedPoint mapped = camera.optics.map(film_from_pixel(camera.film, centre + corner),
                                                     camera.mapping);
        if (!middle.ray || !mapped.ray || mapped.ray->lens != middle.ray->lens)
            return false;
    }
    return true;
}

/// Calls use(centre) for every pixel of a film, or for those that lie whole behind one lens.
inline void for_each_pixel(const IntegralCamera& camera, bool only_whole,
                           const std::function<void(Vec2)>& use)
{
    for (int y = 0; y < camera.film.height; ++y)
        for (int x = 0; x < camera.film.width; ++x)
            if (const Vec2 centre{x + 0.5, y + 0.5}; !only_whole || whole(camera, centre))
                use(centre);
}

constexpr Arrangement arrangements[] = {Arrangement::lenticular, Arrangement::square,
                                        Arrangement::hexagonal};

/// The four coordinates of a ray's origin, 0 to 1 over the pixel and (but for hexagonal lenses) the
/// cell.
inline std::array<double, 4> unit_of(const Origin& at)
{
    return {at.film.x + 0.5, 0.5 - at.film.y, at.lens.x + 0.5, at.lens.y + 0.5};
}

} // namespace pixel_origins

#endif
