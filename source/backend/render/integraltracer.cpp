// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/render/integraltracer.h"
#include "backend/render/integralcolours.h"
#include "backend/render/integralsampling.h"
#include "backend/render/ray.h"
#include "backend/scene/camera.h"
#include "backend/scene/integralcamera.h"
#include "backend/scene/scene.h"

#include <algorithm>
#include <cmath>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

void IntegralTracer::Setup(const Camera& camera, SceneData& scene, TraceThreadData *of_thread,
                           const DBL *of_normal)
{
    normal = of_normal;
    view = camera.Integral_View;
    active = view != nullptr;
    tally = nullptr;
    thread = of_thread;
    if (!active)
        return;
    containers.Choose(*view->optics, scene, thread);
    counts_error = view->error.by_halves;
    clipping = view->clipping;
    quilt = view->quilt != nullptr;
    one_ray = quilt || view->sampler->gives_one_ray();
    run_y = first_y = last_y = -1;
    keeps_depth = view->sampling != nullptr;
    std::lock_guard<std::mutex> lock(view->counts->mutex);
    tally = &view->counts->tallies.emplace_back();
    view->counts->containers = containers.Number();
    view->counts->objects = int(scene.objects.size());
    shading.reset();
    if (view->shading_cache && view->shading_cache->Of_Use() &&
        (!view->caches_dear_shading_only || IntegralCachedShading::Pays(scene)))
        shading.reset(new IntegralCachedShading(*view->shading_cache, *tally, thread));
    const bool reconstructs = view->sampling && view->sampling->Reconstruction();
    area_lights.reset(reconstructs && !shading && IntegralAreaLights::Of_Use(scene)
                          ? new IntegralAreaLights
                          : nullptr);
    ambient.reset(view->ambient_cells ? new IntegralSharedAmbient(*view->ambient_cells, *tally)
                                      : nullptr);
}

void IntegralTracer::Count(const integral::PixelOutcome& outcome, std::size_t traced) const
{
    tally->film_points.Add(outcome.film_points);
    tally->imaged.Add(outcome.imaged);
    tally->searched.Add(outcome.searched);
    tally->outside_aperture.Add(outcome.outside_aperture);
    tally->total_reflection.Add(outcome.total_reflection);
    tally->rays.Add(traced);
    tally->container_searches.Add(containers.None() ? 0 : traced);
}

/// Begins the choice of area lights' parts for the next sample of a pixel.
void IntegralTracer::Choose_Area_Lights(DBL x, DBL y)
{
    if (mode == camera_rays) // radiosity's first pass, which is not a part of the frame
        return area_lights->See_All();
    // With -J, too: if every pixel saw the same parts, that would be another, smaller light.
    const std::uint64_t key = integral::random_bits(
        integral::random_bits(view->seed, std::uint64_t(x)), std::uint64_t(y));
    if (mode == audit)
        area_lights->Begin(integral::random_bits(key, ~audit_set), audit_index);
    else
        area_lights->Begin(key, mode == refinement ? sample_index : 0);
}

/// Sets `rays` to the rays of a pixel through its lens. Returns false if the pixel images nothing.
bool IntegralTracer::Choose_Rays(DBL x, DBL y, bool counted)
{
    const integral::PixelSampler& sampler = *view->sampler;
    const integral::Vec2 centre{x + 0.5, y + 0.5};
    rays.clear();
    if (mode == audit)
        return imaged = sampler.append_random_ray(centre, audit_set, audit_index, rays);

    integral::PixelOutcome outcome;
    if (mode == refinement)
        Append_Sample();
    else
        outcome = sampler.append_rays(centre, rays);
    lens = outcome.lens;
    if (counted)
        Count(outcome, rays.size());
    return imaged = !rays.empty();
}

/// Appends the rays of a sample of the pixel that is being refined.
void IntegralTracer::Append_Sample()
{
    if (beam.number != 1)
        return view->sampler->append_sample(beam, sample_index, rays);
    if (sample_index < refined_begin || sample_index >= refined_end)
    {
        const int number = std::min(samples_wanted, integral::run_length);
        view->sampler->samples(beam.channels[0], sample_index, number, refined_run);
        refined_begin = sample_index;
        refined_end = sample_index + number;
    }
    if (const auto& sample = refined_run[sample_index - refined_begin])
        rays.push_back({*sample, 1, beam.channels[0].channel});
}

/// The index of the pixel in `run`, or -1. If pixels are traced one after the other along a row,
/// the next run is computed when the last one ends.
int IntegralTracer::Place_In_Run(DBL x, DBL y)
{
    const bool next = y == last_y && x == last_x + 1;
    last_x = x;
    last_y = y;
    const DBL place = x - run_x;
    if (y == run_y && place >= 0 && place < integral::run_length && place == int(place))
        return int(place);
    if (!next)
        return -1;
    run_x = x;
    run_y = y;
    integral::map_pixel_run(*view->optics, {x + 0.5, y + 0.5}, run);
    return 0;
}

/// The same for cameras with one ray per pixel; also sets `ray` and `length`.
bool IntegralTracer::Choose_One_Ray(DBL x, DBL y, bool counted, bool pretrace, Ray& ray,
                                    DBL& length)
{
    integral::PixelOutcome outcome;
    const int place = Place_In_Run(x, y);
    if (place >= 0)
    {
        outcome = integral::outcome_of(run.mapped[place]);
        if (run.mapped[place].ray)
            Make_Ray(ray, run.lines[place], pretrace, length);
    }
    else if (const auto seen = view->sampler->one_ray({x + 0.5, y + 0.5}, outcome))
        Make_Ray(ray, *seen, pretrace, length);
    imaged = outcome.imaged > 0;
    lens = outcome.lens;
    if (counted)
        Count(outcome, imaged);
    return imaged;
}

/// The same for the first sample of the pixel's beam.
bool IntegralTracer::Choose_First_Sample(DBL x, DBL y, bool counted, bool pretrace, Ray& ray,
                                         DBL& length)
{
    const integral::Vec2 at{x + 0.5, y + 0.5};
    const int place = Place_In_Run(x, y);
    const integral::MappedPoint mapped = place >= 0
                                             ? run.mapped[place]
                                             : view->optics->optics.map(integral::film_from_pixel(
                                                                            view->optics->film, at),
                                                                        view->optics->mapping);
    const integral::PixelOutcome outcome = integral::outcome_of(mapped);
    imaged = outcome.imaged > 0;
    lens = outcome.lens;
    if (counted)
        Count(outcome, imaged);
    if (!imaged)
        return false;
    centre = integral::pole_beam(*mapped.ray);
    if (place < 0)
        sampled = view->sampler->first_sample(at, *mapped.ray, alike_samples);
    else
    {
        if (run_x != first_x || run_y != first_y)
        {
            view->sampler->first_samples({run_x + 0.5, run_y + 0.5}, run.mapped, alike_samples,
                                         run_samples);
            first_x = run_x;
            first_y = run_y;
        }
        sampled = run_samples[place];
    }
    Make_Ray(ray, sampled, pretrace, length);
    return true;
}

/// The same for a quilt.
bool IntegralTracer::Choose_Quilt_Ray(DBL x, DBL y, bool counted, bool pretrace, Ray& ray,
                                      DBL& length)
{
    integral::PixelOutcome outcome;
    outcome.film_points = 1;
    if (const auto seen = view->quilt->ray({x + 0.5, y + 0.5}))
    {
        outcome.imaged = 1;
        Make_Ray(ray, *seen, pretrace, length);
    }
    else
        outcome.outside_aperture = 1; // left over beside the views
    imaged = outcome.imaged > 0;
    if (counted)
        Count(outcome, imaged);
    return imaged;
}

void IntegralTracer::Refine(int x, int y, bool alike, const integral::FirstSamples& samples,
                            const Colour *first)
{
    mode = refinement;
    std::optional<integral::LensIndex> around;
    if (view->optics->film.subpixels == integral::Subpixels::none)
        around = samples.lens_around(x, y);
    beam = view->sampler->beam({x + 0.5, y + 0.5}, alike, samples.depth(x, y), around);
    refined_begin = refined_end = 0;
    refined = Light();
    if (first)
        refined.Add(integral::PixelRay(), *first);
}

/// Makes the ray that sees along a line what the viewer would see.
void IntegralTracer::Make_Ray(Ray& ray, const integral::SightLine& line, bool pretrace,
                              DBL& length) const
{
    ray.SetFlags(Ray::PrimaryRay, false, false, false, false, pretrace);
    Make_Vector(ray.Origin, line.origin.x, line.origin.y, line.origin.z);
    Make_Vector(ray.Direction, line.direction.x, line.direction.y, line.direction.z);
    if (!containers.None() && !containers.Left_To_POV())
        containers.Tell(ray, thread);
    length = line.length;
}

void IntegralTracer::Make_Ray(Ray& ray, const integral::BeamRay& beam, bool pretrace,
                              DBL& length) const
{
    Make_Ray(ray, integral::sight_line(*view->optics, beam), pretrace, length);
}

integral::BeamSamples::Seen IntegralTracer::Seen(const Colour& colour) const
{
    const integral::SightSlope line = integral::sight_slope(view->optics->optics.lattice(),
                                                            sampled);
    return {line, last_depth, Linear(colour), Tilt(line)};
}

/// How the surface lies that the last ray met along `line` (BeamSamples::Seen::tilt).
std::array<float, 2> IntegralTracer::Tilt(const integral::SightSlope& line) const
{
    if (!(last_depth < HUGE_VAL))
        return {};
    // A plane's normal is a covector: its components along the sheet's axes are products with them.
    const integral::Placement& placement = view->optics->placement;
    const integral::Lattice& lattice = view->optics->optics.lattice();
    const integral::Vec3 of_scene{normal[X], normal[Y], normal[Z]};
    integral::Vec3 facing{dot(of_scene, placement.x), dot(of_scene, placement.y),
                          dot(of_scene, placement.z)};
    if (view->optics->parallax)
        facing = image_of_normal(view->optics->relief,
                                 sheet_from_scene(placement, last_point), facing);
    const integral::Vec2 lateral{facing.x, facing.y};
    const double across = dot(lateral, lattice.across()), along = dot(lateral, lattice.along()),
                 area = across * line.slope[0] + along * line.slope[1] + facing.z;
    return area < 0 || area > 0 ? std::array<float, 2>{float(across / area), float(along / area)}
                                : std::array<float, 2>{};
}

void IntegralTracer::Keep_Depth(const Ray& ray, DBL distance)
{
    last_depth = HUGE_VAL;
    if (!(distance < HUGE_VAL))
        return;
    last_point = From_POV(ray.Origin) + distance * From_POV(ray.Direction);
    last_depth = seen_from_scene(*view->optics, last_point).z;
}

void IntegralTracer::Light::Add(const integral::PixelRay& ray, const Colour& seen)
{
    const int channel = ray.channel == integral::PixelRay::all_channels ? int(all) : ray.channel;
    rays[ray.half]++;
    sums[ray.half][channel] += seen * ray.weight;
    weights[ray.half][channel] += ray.weight;
}

Colour IntegralTracer::Light::Mean(int half) const
{
    Colour mean;
    mean.clear();
    for (int channel = 0; channel < 3; channel++)
    {
        Colour sum;
        sum.clear();
        DBL weight = 0;
        for (int k = 0; k < 2; k++)
            if (half == 2 || half == k)
            {
                sum += sums[k][channel] + sums[k][all];
                weight += weights[k][channel] + weights[k][all];
            }
        // a channel without rays is black
        mean[channel] = weight > 0 ? sum[channel] / weight : 0.0;
        mean.filter() += weight > 0 ? sum.filter() / (3 * weight) : 0.0;
        mean.transm() += weight > 0 ? sum.transm() / (3 * weight) : 1.0 / 3;
    }
    return mean;
}

void IntegralTracer::Count_Error(DBL y, const Light& light)
{
    if (!view->rows.Have(int(y)) || light.rays[0] == 0 || light.rays[1] == 0)
        return;
    const Colour first = light.Mean(0), second = light.Mean(1);
    tally->errors.add(integral::halves_error(
        view->error.output, {first.red(), first.green(), first.blue()},
        {second.red(), second.green(), second.blue()}, light.rays[0], light.rays[1]));
}

}
