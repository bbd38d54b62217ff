// SPDX-License-Identifier: AGPL-3.0-or-later
// The beams of PixelSampler: how a pixel and its lens are prepared for anti-aliasing, and the
// samples of such a beam after the first one.
#include "integral/lightfield/pixel_sampler.h"

#include <cmath>

namespace integral {

namespace {

// The places of a pixel whose pole rays its beam is worked out from: the centre, the corners, and
// the middles of the right and of the upper edge. In parts of the pixel from its centre; the last
// one fills the run.
constexpr RayRun<Vec2> beam_places{
    {{0, 0}, {-0.5, -0.5}, {-0.5, 0.5}, {0.5, -0.5}, {0.5, 0.5}, {0.5, 0}, {0, 0.5}, {0, 0}}};

} // namespace

/// Finds the lens of a pixel, whether it images all of the pixel, and its rays from the pixel's
/// centre and from the middles of the right and of the upper edge.
PixelSampler::BeamRays PixelSampler::beam_rays(Vec2 film_centre) const
{
    RayRun<Vec2> film_points;
    for (int k = 0; k < run_length; ++k)
        film_points[k] = film_centre + Vec2{beam_places[k].x * area_.x, beam_places[k].y * area_.y};
    RayRun<MappedPoint> mapped;
    camera_.optics.map_run(film_points, camera_.mapping, mapped);
    BeamRays rays;
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

/// The same where a lens is known to image all of the pixel.
PixelSampler::BeamRays PixelSampler::beam_rays_through(Vec2 film_centre, LensIndex lens) const
{
    const auto ray = [&](double x, double y) {
        return camera_.optics.ray_through(film_centre + Vec2{x * area_.x, y * area_.y}, lens);
    };
    return {ray(0, 0), ray(0.5, 0), ray(0, 0.5), true};
}

/// Sets how far the point seen at `depth` moves with the position on the pixel and with the
/// position on the lens's cell. The pole rays of the pixel's centre, and of the middles of its
/// right and of its upper edge.
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

PixelBeam PixelSampler::beam(Vec2 centre, bool alike, double depth,
                             std::optional<LensIndex> around) const
{
    PixelBeam beam;
    const bool divided = camera_.film.subpixels != Subpixels::none;
    for (int channel = divided ? 0 : PixelRay::all_channels; channel < (divided ? 3 : 0);
         ++channel) {
        const Vec2 film_centre = channel_centre(centre, channel);
        const BeamRays rays = around ? beam_rays_through(film_centre, *around)
                                     : beam_rays(film_centre);
        if (!rays.centre)
            continue;
        PixelBeam::Channel& own = beam.channels[beam.number++];
        own.channel = channel;
        own.film_centre = film_centre;
        own.lens = rays.centre->lens;
        own.whole = rays.whole;
        if (rays.right && rays.up)
            aim(own, *rays.centre, *rays.right, *rays.up, depth);
        const UnitPoint first = first_point(film_centre, own.lens, channel, alike);
        const auto across = own.across.inverse({first[0], first[own.turned ? 3 : 2]}),
                   along = own.along.inverse({first[1], first[own.turned ? 2 : 3]});
        own.points = ShiftedPoints(
            lens_seeds(alike ? LensIndex{} : own.lens, channel, shifted_points),
            {across.first, along.first, across.second, along.second});
    }
    return beam;
}

/// The ray of one sample of a beam; nothing if another lens images the film point, or no light gets
/// through. `unit`: the place on the lens.
std::optional<BeamRay> PixelSampler::beam_sample(const PixelBeam::Channel& own, Vec2 film_point,
                                                 Vec2 unit) const
{
    const SheetOptics& optics = camera_.optics;
    if (own.whole && slit_height_) // no pole ray is needed
        return beam_ray(optics, film_point, own.lens,
                        cell_point(optics.lattice(), unit, *slit_height_));
    const auto pole_ray = own.whole ? optics.ray_through(film_point, own.lens)
                                    : sample_ray(film_point, own.lens);
    return pole_ray ? ray_at(film_point, *pole_ray, lens_point(unit, *pole_ray)) : std::nullopt;
}

void PixelSampler::append_sample(const PixelBeam& beam, std::uint32_t index,
                                 std::vector<PixelRay>& rays) const
{
    for (int k = 0; k < beam.number; ++k) {
        const PixelBeam::Channel& own = beam.channels[k];
        const UnitPoint unit = own.points(index);
        const SumSplit::Parts across = own.across(unit[0], unit[2]),
                              along = own.along(unit[1], unit[3]);
        const Vec2 pixel = own.turned ? Vec2{along.second, across.second}
                                      : Vec2{across.second, along.second};
        const auto ray = beam_sample(own, moved(own.film_centre, pixel),
                                     {across.first, along.first});
        if (!ray)
            continue;
        PixelRay sample;
        sample.channel = own.channel;
        sample.ray = *ray;
        rays.push_back(sample);
    }
}

} // namespace integral
