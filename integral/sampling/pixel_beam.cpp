// SPDX-License-Identifier: AGPL-3.0-or-later
// The beams of PixelSampler: how a pixel and its lens are prepared for anti-aliasing, and the
// samples of such a beam.
#include "integral/sampling/pixel_sampler.h"

#include <cmath>

namespace integral {

namespace {

// Places on a pixel whose pole rays determine its beam: the centre, the corners, and the middles of
// the right and upper edges. As fractions of the pixel, from its centre.
constexpr std::array<Vec2, 7> beam_places{
    {{0, 0}, {-0.5, -0.5}, {-0.5, 0.5}, {0.5, -0.5}, {0.5, 0.5}, {0.5, 0}, {0, 0.5}}};

} // namespace

/// Finds the lens of a pixel, whether this lens images all of the pixel, and the lens's pole rays
/// from the pixel's centre and from the middles of the pixel's right and upper edges.
PixelSampler::PoleRays PixelSampler::pole_rays_searched(Vec2 film_centre) const
{
    RayRun<Vec2> film_points;
    for (std::size_t k = 0; k < beam_places.size(); ++k)
        film_points[k] = film_centre + Vec2{beam_places[k].x * area_.x, beam_places[k].y * area_.y};
    RayRun<MappedPoint> mapped;
    camera_.optics.map_run(int(beam_places.size()), film_points, camera_.mapping, mapped);
    PoleRays rays;
    rays.centre = mapped[0].ray;
    if (!rays.centre)
        return rays;
    const LensIndex lens = rays.centre->lens;
    const auto has = [&](int k) { return mapped[k].ray && mapped[k].ray->lens == lens; };
    const auto own_ray = [&](int k) {
        return has(k) ? mapped[k].ray : camera_.optics.ray_through(film_points[k], lens);
    };
    rays.whole = camera_.display_prefilter || (has(1) && has(2) && has(3) && has(4));
    rays.right = own_ray(5);
    rays.up = own_ray(6);
    return rays;
}

/// The same for a lens that is known to image the whole pixel.
PixelSampler::PoleRays PixelSampler::pole_rays_through(Vec2 film_centre, LensIndex lens) const
{
    const RayRun<Vec2> film_points{film_centre, film_centre + Vec2{0.5 * area_.x, 0},
                                   film_centre + Vec2{0, 0.5 * area_.y}};
    RayRun<std::optional<LensRay>> rays;
    camera_.optics.rays_through(3, film_points, lens, rays);
    return {rays[0], rays[1], rays[2], true};
}

/// Sets how far the point seen at `depth` moves with the position on the pixel and with the
/// position on the lens's cell. `centre`, `right`, `up`: pole rays of the pixel's centre, and of
/// the middles of its right and upper edges.
void PixelSampler::aim(PixelBeam::Channel& own, const LensRay& centre, const LensRay& right,
                       const LensRay& up, double depth) const
{
    const Lattice& lattice = camera_.optics.lattice();
    const bool lenticular = lattice.arrangement() == Arrangement::lenticular;
    const double far = 1e6 * lattice.pitch(),
                 z = std::fmax(-far, std::fmin(depth, far)); // NaN: far
    const auto seen = [&](const LensRay& ray) {
        return ray.pole + (z / ray.direction.z) * Vec2{ray.direction.x, ray.direction.y};
    };
    const Vec2 by_width = 2 * (seen(right) - seen(centre)),
               by_height = 2 * (seen(up) - seen(centre));
    const Vec2 across{dot(by_width, lattice.across()), dot(by_height, lattice.across())};
    const Vec2 along{dot(by_width, lattice.along()), dot(by_height, lattice.along())};
    own.turned = std::fabs(across.y) > std::fabs(across.x);
    const double mirrored = camera_.pseudoscopic ? -1 : 1;
    own.across = SumSplit(mirrored * (own.turned ? across.y : across.x) / lattice.pitch());
    const double by_pixel = own.turned ? along.x : along.y;
    const double by_slit = -z / camera_.optics.aperture().distance *
                           camera_.slit_height(centre.aperture_point);
    own.along = SumSplit(lenticular ? by_pixel / by_slit
                                    : mirrored * by_pixel / lattice.row_spacing());
}

PixelBeam PixelSampler::beam(Vec2 centre, bool same_pattern, double depth,
                             std::optional<LensIndex> around) const
{
    PixelBeam beam;
    const bool divided = camera_.film.subpixels != Subpixels::none;
    for (int channel = divided ? 0 : PixelRay::all_channels; channel < (divided ? 3 : 0);
         ++channel) {
        const Vec2 film_centre = channel_centre(centre, channel);
        const PoleRays rays = around ? pole_rays_through(film_centre, *around)
                                     : pole_rays_searched(film_centre);
        if (!rays.centre)
            continue;
        PixelBeam::Channel& own = beam.channels[beam.number++];
        own.channel = channel;
        own.film_centre = film_centre;
        own.lens = rays.centre->lens;
        own.whole = rays.whole;
        if (rays.right && rays.up)
            aim(own, *rays.centre, *rays.right, *rays.up, depth);
        const UnitPoint first = first_point(film_centre, own.lens, channel, same_pattern);
        const auto across = own.across.inverse({first[0], first[own.turned ? 3 : 2]}),
                   along = own.along.inverse({first[1], first[own.turned ? 2 : 3]});
        own.points = ShiftedPoints(
            lens_seeds(same_pattern ? LensIndex{} : own.lens, channel, shifted_points),
            {across.first, along.first, across.second, along.second});
    }
    return beam;
}

/// Rays of a beam's samples at `number` film points; nothing for a point that another lens images,
/// or if no light gets through. `units`: the places on the lens, in the unit square.
void PixelSampler::beam_samples(const PixelBeam::Channel& own, int number,
                                const RayRun<Vec2>& film_points, const RayRun<Vec2>& units,
                                RayRun<std::optional<BeamRay>>& rays) const
{
    const SheetOptics& optics = camera_.optics;
    if (own.whole && slit_height_) { // no pole rays are needed
        RayRun<LensPoint> points;
        for (int k = 0; k < number; ++k)
            points[k] = cell_point(optics.lattice(), units[k], *slit_height_);
        return beam_rays(optics, number, film_points, own.lens, points, rays);
    }
    RayRun<std::optional<LensRay>> pole_rays;
    if (own.whole)
        optics.rays_through(number, film_points, own.lens, pole_rays);
    else { // not with the display prefilter, whose beams are whole
        RayRun<MappedPoint> mapped;
        optics.map_run(number, film_points, camera_.mapping, mapped);
        for (int k = 0; k < number; ++k)
            if (mapped[k].ray && mapped[k].ray->lens == own.lens)
                pole_rays[k] = mapped[k].ray;
    }
    for (int k = 0; k < number; ++k)
        rays[k] = pole_rays[k]
                      ? ray_at(film_points[k], *pole_rays[k], lens_point(units[k], *pole_rays[k]))
                      : std::nullopt;
}

void PixelSampler::samples(const PixelBeam::Channel& own, std::uint32_t begin, int number,
                           RayRun<std::optional<BeamRay>>& rays) const
{
    RayRun<Vec2> film_points, units;
    for (int k = 0; k < number; ++k) {
        const UnitPoint unit = own.points(begin + std::uint32_t(k));
        const SumSplit::Parts across = own.across(unit[0], unit[2]),
                              along = own.along(unit[1], unit[3]);
        film_points[k] = moved(own.film_centre, own.turned ? Vec2{along.second, across.second}
                                                           : Vec2{across.second, along.second});
        units[k] = {across.first, along.first};
    }
    beam_samples(own, number, film_points, units, rays);
}

void PixelSampler::append_sample(const PixelBeam& beam, std::uint32_t index,
                                 std::vector<PixelRay>& rays) const
{
    for (int k = 0; k < beam.number; ++k) {
        RayRun<std::optional<BeamRay>> ray;
        samples(beam.channels[k], index, 1, ray);
        if (!ray[0])
            continue;
        PixelRay sample;
        sample.channel = beam.channels[k].channel;
        sample.ray = *ray[0];
        rays.push_back(sample);
    }
}

} // namespace integral
