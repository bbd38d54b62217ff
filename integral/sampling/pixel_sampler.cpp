// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/sampling/pixel_sampler.h"

#include <cmath>
#include <cstring>

namespace integral {

namespace {

constexpr int search_limit = 64; // random points tried until one belongs to the lens; the last is
                                 // the centre

} // namespace

PixelOutcome outcome_of(const MappedPoint& mapped)
{
    PixelOutcome outcome;
    outcome.film_points = 1;
    outcome.outside_aperture = mapped.empty == Empty::outside_aperture;
    outcome.total_reflection = mapped.empty == Empty::total_reflection;
    if (mapped.ray) {
        outcome.imaged = 1;
        outcome.lens = mapped.ray->lens;
        outcome.searched = mapped.searched;
    }
    return outcome;
}

PixelSampler::PixelSampler(const IntegralCamera& camera, std::uint64_t seed)
    : camera_(camera), seed_(random_bits(0, seed))
{
    const SheetOptics& optics = camera.optics;
    const Vec2 size = subpixel_size(camera.film.subpixels);
    area_ = {size.x * camera.film.pixel_pitch.x, size.y * camera.film.pixel_pitch.y};
    const bool hybrid = optics.model() == LensModel::hybrid;
    if (hybrid)
        hybrid_ = hybrid_points(optics.lattice());
    const bool cell_is_flat = optics.sheet().arrangement == Arrangement::lenticular &&
                              !(camera.slit_height({0, 0}) > 0);
    film_dimensions_ = camera.pixel_samples > 1 ? 2 : 0;
    lens_dimensions_ = hybrid || camera.beam_samples == 1 ? 0 : cell_is_flat ? 1 : 2;
    one_ray_ = film_dimensions_ + lens_dimensions_ == 0 && !hybrid && !camera.pseudoscopic &&
               camera.film.subpixels == Subpixels::none && optics.model() != LensModel::full;
    if (optics.sheet().arrangement == Arrangement::lenticular && !cell_is_flat &&
        optics.aperture().shape == ApertureShape::rectangle && !camera.display_prefilter &&
        !camera.pseudoscopic)
        slit_height_ = camera.slit_height({0, 0});
}

bool PixelSampler::halves_tell_error() const
{
    constexpr int enough = 16; // with fewer samples, the encoding's curvature hides part of the
                               // error
    return film_dimensions_ > 0 && lens_dimensions_ > 0 &&
           camera_.pixel_samples * camera_.beam_samples >= enough;
}

std::uint64_t PixelSampler::pixel_key(Vec2 centre) const
{
    // Use all bits of the centre, so that samples within one pixel get different keys.
    const auto bits = [](double x) {
        std::uint64_t image;
        std::memcpy(&image, &x, sizeof image);
        return image;
    };
    return random_bits(random_bits(seed_, bits(centre.x)), bits(centre.y));
}

double PixelSampler::random_shift(std::uint64_t key, std::uint64_t index, int dimension) const
{
    return double(random_bits(random_bits(key, index), std::uint64_t(dimension)) >> 11) * 0x1p-53;
}

Vec2 PixelSampler::channel_centre(Vec2 centre, int channel) const
{
    if (channel != PixelRay::all_channels)
        centre = centre + subpixel_shift(camera_.film.subpixels, centre, channel);
    return film_from_pixel(camera_.film, centre);
}

/// The pole ray of a film point, if `lens` images it; else nothing.
std::optional<LensRay> PixelSampler::sample_ray(Vec2 film_point, LensIndex lens) const
{
    if (camera_.display_prefilter)
        return camera_.optics.ray_through(film_point, lens);
    const auto ray = camera_.optics.map(film_point, camera_.mapping).ray;
    return ray && ray->lens == lens ? ray : std::nullopt;
}

LensPoint PixelSampler::lens_point(Vec2 unit, const LensRay& pole_ray) const
{
    const double slit_height = camera_.slit_height(pole_ray.aperture_point);
    return camera_.display_prefilter ? tent_point(camera_.optics.lattice(), unit, slit_height)
                                     : cell_point(camera_.optics.lattice(), unit, slit_height);
}

/// Sample `index` of a channel. The samples form two independent sets (`half` 0 and 1), each well
/// distributed over the sampled dimensions.
PixelSampler::PixelPoint PixelSampler::even_point(std::uint64_t key, int index, int& half) const
{
    PixelPoint point;
    half = 0;
    const int dimensions = film_dimensions_ + lens_dimensions_;
    if (dimensions == 0)
        return point;
    const int all = camera_.pixel_samples * (lens_dimensions_ > 0 ? camera_.beam_samples : 1);
    const int first = all / 2;
    half = index >= first;
    const int within = half ? index - first : index;
    const auto unit = scrambled_point(point_seeds(random_bits(key, half)), within);
    if (film_dimensions_ > 0)
        point.pixel = {unit[0], unit[1]};
    if (lens_dimensions_ > 0)
        point.lens.x = unit[film_dimensions_];
    if (lens_dimensions_ > 1)
        point.lens.y = unit[film_dimensions_ + 1];
    return point;
}

/// The ray of a film point through a point of its lens; nothing if no light gets through.
std::optional<BeamRay> PixelSampler::ray_at(Vec2 film_point, const LensRay& pole_ray,
                                            const LensPoint& point) const
{
    const SheetOptics& optics = camera_.optics;
    if (camera_.pseudoscopic)
        return beam_ray(optics, mirrored_in_lens(optics, film_point, pole_ray.lens), pole_ray.lens,
                        point);
    if (refracts_at_surface(optics.model()) || point.slit != 0)
        return beam_ray(optics, film_point, pole_ray.lens, point);
    BeamRay beam = pole_beam(pole_ray);
    beam.point = beam.point + Vec3{point.offset.x, point.offset.y, 0};
    beam.aperture_point = beam.aperture_point + point.offset;
    return beam;
}

void PixelSampler::append_ray(Vec2 film_point, const LensRay& pole_ray, const LensPoint& point,
                              PixelRay ray, std::vector<PixelRay>& rays) const
{
    const auto beam = ray_at(film_point, pole_ray, point);
    if (!beam)
        return;
    ray.ray = *beam;
    rays.push_back(ray);
}

void PixelSampler::append_channel(Vec2 centre, int channel, std::uint64_t key,
                                  std::vector<PixelRay>& rays, PixelOutcome& outcome) const
{
    const SheetOptics& optics = camera_.optics;
    const Vec2 film_centre = channel_centre(centre, channel);
    const MappedPoint mapped = optics.map(film_centre, camera_.mapping);
    ++outcome.film_points;
    outcome.outside_aperture += mapped.empty == Empty::outside_aperture;
    outcome.total_reflection += mapped.empty == Empty::total_reflection;
    if (!mapped.ray)
        return;

    const std::size_t before = rays.size();
    const int samples = camera_.pixel_samples * (lens_dimensions_ > 0 ? camera_.beam_samples : 1);
    const std::uint64_t channel_key = random_bits(key, std::uint64_t(channel + 1));
    const auto append_samples = [&](bool over_area) {
        bool own = false; // whether any sample belongs to the lens
        for (int index = 0; index < samples; ++index) {
            PixelRay ray;
            ray.channel = channel;
            const PixelPoint unit = even_point(channel_key, index, ray.half);
            const Vec2 film_point = over_area ? moved(film_centre, unit.pixel) : film_centre;
            const auto at = over_area ? sample_ray(film_point, mapped.ray->lens) : mapped.ray;
            if (!at)
                continue; // another lens images it, or none
            own = true;
            if (hybrid_.empty())
                append_ray(film_point, *at, lens_point(unit.lens, *at), ray, rays);
            for (const WeightedLensPoint& marginal : hybrid_) {
                ray.weight = marginal.weight;
                append_ray(film_point, *at, marginal.point, ray, rays);
            }
        }
        return own;
    };
    if (!append_samples(film_dimensions_ > 0))
        append_samples(false);
    const bool any = rays.size() > before;
    outcome.imaged += any;
    outcome.searched += any && mapped.searched;
    outcome.total_reflection += !any;
    if (any && channel != 2)
        outcome.lens = mapped.ray->lens;
}

std::optional<BeamRay> PixelSampler::one_ray(Vec2 centre, PixelOutcome& outcome) const
{
    const MappedPoint mapped = camera_.optics.map(film_from_pixel(camera_.film, centre),
                                                  camera_.mapping);
    outcome = outcome_of(mapped);
    return mapped.ray ? std::optional(pole_beam(*mapped.ray)) : std::nullopt;
}

PixelOutcome PixelSampler::append_rays(Vec2 centre, std::vector<PixelRay>& rays) const
{
    PixelOutcome outcome;
    if (one_ray_) {
        if (const auto ray = one_ray(centre, outcome))
            rays.push_back({*ray});
        return outcome;
    }
    const std::uint64_t key = pixel_key(centre);
    if (camera_.film.subpixels == Subpixels::none)
        append_channel(centre, PixelRay::all_channels, key, rays, outcome);
    else
        for (int channel = 0; channel < 3; ++channel)
            append_channel(centre, channel, key, rays, outcome);
    return outcome;
}

std::optional<BeamRay> PixelSampler::pole_ray(Vec2 centre) const
{
    const Vec2 film_point = film_from_pixel(camera_.film, centre);
    const auto ray = camera_.optics.map(film_point, camera_.mapping).ray;
    return ray ? ray_at(film_point, *ray, {}) : std::nullopt;
}

bool PixelSampler::append_reference_ray(Vec2 centre, std::uint64_t set, std::uint32_t index,
                                        std::vector<PixelRay>& rays) const
{
    const SheetOptics& optics = camera_.optics;
    const std::size_t before = rays.size();
    const bool divided = camera_.film.subpixels != Subpixels::none;
    for (int channel = divided ? 0 : PixelRay::all_channels; channel < (divided ? 3 : 0);
         ++channel) {
        const Vec2 film_centre = channel_centre(centre, channel);
        const MappedPoint mapped = optics.map(film_centre, camera_.mapping);
        if (!mapped.ray)
            continue;
        const std::uint64_t key = random_bits(
            random_bits(pixel_key(centre), std::uint64_t(channel + 1)), ~set);
        const auto even = scrambled_point(point_seeds(key), index);
        const std::size_t own = rays.size();
        for (int attempt = 0; attempt < search_limit && rays.size() == own; ++attempt) {
            const auto random = [&](int dimension) {
                return attempt == 0 ? even[dimension]
                                    : random_shift(key, index * search_limit + attempt, dimension);
            };
            const bool last = attempt + 1 == search_limit;
            const Vec2 film_point = last ? film_centre : moved(film_centre, {random(2), random(3)});
            const auto at = sample_ray(film_point, mapped.ray->lens);
            if (!at)
                continue;
            PixelRay ray;
            ray.channel = channel;
            append_ray(film_point, *at, lens_point({random(0), random(1)}, *at), ray, rays);
        }
    }
    return rays.size() > before;
}

/// The seeds of one of the sequences that pixels behind a lens share.
PointSeeds PixelSampler::lens_seeds(LensIndex lens, int channel, std::uint64_t sequence) const
{
    const std::uint64_t key = random_bits(seed_,
                                          std::uint64_t(lens.i) << 32 ^ std::uint32_t(lens.j));
    return point_seeds(random_bits(key, sequence << 2 | std::uint64_t(channel + 1)));
}

/// Place of a pixel's first point: its sequence, and its index there. The first points of adjacent
/// pixels behind a lens are near each other in one sequence, so that they fill each other's gaps.
/// `same_pattern`: the place is the same for all pixels.
PixelSampler::PlaceInSequence PixelSampler::place_of_first(Vec2 film_centre, LensIndex lens,
                                                           bool same_pattern) const
{
    if (same_pattern)
        return {{}, first_points, 0};
    const Vec2 pitch = camera_.film.pixel_pitch,
               from_pole = film_centre - camera_.optics.lattice().pole(lens);
    // Poles often lie in the middle or at the edge of a pixel. A shift by a quarter avoids both, so
    // that rounding does not give two pixels the same place.
    const auto place = [](double pixels) {
        return std::uint32_t(std::int64_t(std::floor(pixels + 0.25)) + curve_side / 2);
    };
    const std::uint32_t x = place(from_pole.x / pitch.x), y = place(from_pole.y / pitch.y);
    const std::uint64_t square = std::uint64_t(x / curve_side) << 32 | y / curve_side;
    return {lens, first_points + square, place_on_curve(x % curve_side, y % curve_side)};
}

/// The coordinates of a pixel's first sample: two on the cell, then two on the pixel's area.
/// `same_pattern`: they are the same for all pixels.
UnitPoint PixelSampler::first_point(Vec2 film_centre, LensIndex lens, int channel,
                                    bool same_pattern) const
{
    const PlaceInSequence place = place_of_first(film_centre, lens, same_pattern);
    return scrambled_point(lens_seeds(place.lens, channel, place.sequence), place.index);
}

/// The first sample, at a film point and a place on the cell. `at`: the film point's pole ray.
BeamRay PixelSampler::first_ray(const LensRay& pole_ray, Vec2 film_point, const UnitPoint& unit,
                                const std::optional<LensRay>& at) const
{
    std::optional<BeamRay> beam;
    if (at && at->lens == pole_ray.lens)
        beam = ray_at(film_point, *at, lens_point({unit[0], unit[1]}, *at));
    return beam ? *beam : pole_beam(pole_ray);
}

BeamRay PixelSampler::first_sample(Vec2 centre, const LensRay& pole_ray, bool same_pattern) const
{
    const Vec2 film_centre = film_from_pixel(camera_.film, centre);
    const UnitPoint unit = first_point(film_centre, pole_ray.lens, PixelRay::all_channels,
                                       same_pattern);
    const Vec2 film_point = moved(film_centre, {unit[2], unit[3]});
    return first_ray(pole_ray, film_point, unit, sample_ray(film_point, pole_ray.lens));
}

void PixelSampler::first_samples(Vec2 centre, const RayRun<MappedPoint>& mapped, bool same_pattern,
                                 RayRun<BeamRay>& samples) const
{
    RayRun<Vec2> film_points;
    RayRun<UnitPoint> units;
    std::optional<PlaceInSequence> begun; // place of the pixel before; `seeds`: of its sequence
    PointSeeds seeds{};
    for (int k = 0; k < run_length; ++k) {
        film_points[k] = film_from_pixel(camera_.film, {centre.x + k, centre.y});
        if (!mapped[k].ray)
            continue;
        const PlaceInSequence place = place_of_first(film_points[k], mapped[k].ray->lens,
                                                     same_pattern);
        if (!begun || place.lens != begun->lens || place.sequence != begun->sequence)
            seeds = lens_seeds(place.lens, PixelRay::all_channels, place.sequence);
        begun = place;
        units[k] = scrambled_point(seeds, place.index);
        film_points[k] = moved(film_points[k], {units[k][2], units[k][3]});
    }
    RayRun<MappedPoint> at;
    camera_.optics.map_run(run_length, film_points, camera_.mapping, at);
    for (int k = 0; k < run_length; ++k)
        if (mapped[k].ray)
            samples[k] = first_ray(*mapped[k].ray, film_points[k], units[k], at[k].ray);
}

} // namespace integral
