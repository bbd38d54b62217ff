// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/render/integraltracer.h"
#include "backend/render/integralcolours.h"
#include "backend/render/integralsampling.h"
#include "backend/render/ray.h"
#include "backend/render/tracepixel.h"
#include "backend/scene/camera.h"
#include "backend/scene/integralcamera.h"
#include "backend/scene/scene.h"

#include <algorithm>
#include <cmath>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

/// Traces a ray up to the distance `length` (scene units; 0 = unlimited). Returns the distance of
/// the surface that it met; HUGE_VAL: none.
DBL TracePixel::Trace_Integral_Ray(Ray& ray, DBL length, Colour& colour)
{
    if (integralTracer.Search_Containers())
        InitRayContainerState(ray, true);
    Trace::TraceTicket ticket(maxTraceLevel, adcBailout, sceneData->outputAlpha);
    return TraceRay(ray, colour, 1.0, ticket, false, length);
}

void IntegralTracer::Setup(const Camera& camera, SceneData& scene, TraceThreadData *of_thread,
                           TracePixel& of_pixels, const DBL *of_normal)
{
    view = camera.Integral_View;
    pixels = &of_pixels;
    normal = of_normal;
    thread = of_thread;
    if (!Active())
        return;
    containers.Choose(*view->optics, scene, thread);
    walk = Row_Walk();
    finds_depth = view->sampling != nullptr;
    std::lock_guard<std::mutex> lock(view->counts->mutex);
    counters = &view->counts->tallies.emplace_back();
    view->counts->containers = containers.Number();
    view->counts->objects = int(scene.objects.size());
    shading.reset();
    if (view->shading_cache && view->shading_cache->Of_Use() &&
        (!view->cache_expensive_shading_only || IntegralCachedShading::Pays(scene)))
        shading.reset(new IntegralCachedShading(*view->shading_cache, *counters, thread));
    const bool reconstructs = view->sampling && view->sampling->Reconstruction();
    area_lights.reset(reconstructs && !shading && IntegralAreaLights::Of_Use(scene)
                          ? new IntegralAreaLights
                          : nullptr);
    ambient.reset(view->ambient_cells ? new IntegralSharedAmbient(*view->ambient_cells, *counters)
                                      : nullptr);
}

void IntegralTracer::Count(const integral::PixelOutcome& outcome, std::size_t traced) const
{
    counters->film_points.Add(outcome.film_points);
    counters->imaged.Add(outcome.imaged);
    counters->searched.Add(outcome.searched);
    counters->outside_aperture.Add(outcome.outside_aperture);
    counters->total_reflection.Add(outcome.total_reflection);
    counters->rays.Add(traced);
    counters->container_searches.Add(containers.None() ? 0 : traced);
}

/// A random key of pixel (x, y), also with -J: if every pixel saw the same parts of an area light, the frame
/// would show another, smaller light.
static std::uint64_t Pixel_Key(const IntegralView& view, DBL x, DBL y)
{
    return integral::random_bits(integral::random_bits(view.seed, std::uint64_t(x)),
                                 std::uint64_t(y));
}

void IntegralTracer::Begin_Sample(DBL x, DBL y, std::uint32_t index)
{
    if (area_lights)
        area_lights->Begin(Pixel_Key(*view, x, y), index);
}

void IntegralTracer::Begin_Reference(DBL x, DBL y, std::uint64_t set, std::uint32_t index)
{
    if (area_lights)
        area_lights->Begin(integral::random_bits(Pixel_Key(*view, x, y), ~set), index);
}

IntegralHit IntegralTracer::Trace(const integral::SightLine& line, bool pretrace)
{
    Ray ray;
    ray.SetFlags(Ray::PrimaryRay, false, false, false, false, pretrace);
    Make_Vector(ray.Origin, line.origin.x, line.origin.y, line.origin.z);
    Make_Vector(ray.Direction, line.direction.x, line.direction.y, line.direction.z);
    if (!containers.None() && !containers.Use_Generic_Search())
        containers.Add_Interiors(ray, thread);
    IntegralHit hit;
    const DBL distance = pixels->Trace_Integral_Ray(ray, line.length, hit.light);
    if (finds_depth && distance < HUGE_VAL)
    {
        hit.point = From_POV(ray.Origin) + distance * From_POV(ray.Direction);
        hit.depth = seen_from_scene(*view->optics, hit.point).z;
        hit.normal = From_POV(normal);
    }
    Clip(view->clipping, hit.light);
    return hit;
}

IntegralHit IntegralTracer::Trace(const integral::BeamRay& ray, bool pretrace)
{
    return Trace(integral::sight_line(*view->optics, ray), pretrace);
}

IntegralHit IntegralTracer::Trace(const std::vector<integral::PixelRay>& rays, IntegralLight& light,
                                  bool pretrace)
{
    IntegralHit hit;
    for (const integral::PixelRay& ray : rays)
    {
        hit = Trace(ray.ray, pretrace);
        light.Add(ray, hit.light);
    }
    if (rays.size() > 1 || rays[0].channel != integral::PixelRay::all_channels)
        hit.light = light.Mean(2);
    return hit;
}

IntegralPixel IntegralTracer::Trace_Pixel(DBL x, DBL y, bool pretrace)
{
    if (area_lights) // radiosity's first pass, which is not a part of the frame
        area_lights->See_All();
    return view->quilt                      ? Trace_Quilt_Pixel(x, y, pretrace)
           : view->sampler->gives_one_ray() ? Trace_One_Ray(x, y, pretrace)
                                            : Trace_Samples(x, y, pretrace);
}

/// The pixel that one ray gives; without a hit, a pixel that images nothing.
static IntegralPixel Pixel_Of(const std::optional<IntegralHit>& hit, const integral::LensIndex& lens)
{
    return hit ? IntegralPixel{hit->light, lens, hit->depth} : IntegralPixel::Without_Light();
}

int IntegralTracer::Row_Walk::Place(const integral::IntegralCamera& camera, DBL x, DBL y)
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
    integral::map_pixel_run(camera, {x + 0.5, y + 0.5}, run);
    return 0;
}

IntegralPixel IntegralTracer::Trace_One_Ray(DBL x, DBL y, bool pretrace)
{
    integral::PixelOutcome outcome;
    std::optional<IntegralHit> hit;
    const int place = walk.Place(*view->optics, x, y);
    if (place >= 0)
    {
        const integral::MappedPoint& mapped = walk.Run().mapped[place];
        outcome = integral::outcome_of(mapped);
        if (mapped.ray)
            hit = Trace(walk.Run().lines[place], pretrace);
    }
    else if (const auto ray = view->sampler->one_ray({x + 0.5, y + 0.5}, outcome))
        hit = Trace(*ray, pretrace);
    if (!pretrace)
        Count(outcome, outcome.imaged);
    return Pixel_Of(hit, outcome.lens);
}

IntegralPixel IntegralTracer::Trace_Quilt_Pixel(DBL x, DBL y, bool pretrace)
{
    const integral::PixelOutcome outcome = view->quilt->outcome(int(x), int(y));
    std::optional<IntegralHit> hit;
    if (const auto ray = view->quilt->ray({x + 0.5, y + 0.5}))
        hit = Trace(*ray, pretrace);
    if (!pretrace)
        Count(outcome, outcome.imaged);
    return Pixel_Of(hit, outcome.lens);
}

/// Traces a pixel by several rays, or by rays for single colour channels.
IntegralPixel IntegralTracer::Trace_Samples(DBL x, DBL y, bool pretrace)
{
    rays.clear();
    const integral::PixelOutcome outcome = view->sampler->append_rays({x + 0.5, y + 0.5}, rays);
    if (!pretrace)
        Count(outcome, rays.size());
    if (rays.empty())
        return Pixel_Of({}, outcome.lens);
    IntegralLight light;
    const IntegralHit hit = Trace(rays, light, pretrace);
    if (!pretrace && view->error.by_halves)
        Count_Error(y, light);
    return Pixel_Of(hit, outcome.lens);
}

void IntegralTracer::Count_Error(DBL y, const IntegralLight& light)
{
    if (!view->rows.Have(int(y)) || light.Rays(0) == 0 || light.Rays(1) == 0)
        return;
    const Colour first = light.Mean(0), second = light.Mean(1);
    counters->errors.add(integral::halves_error(
        view->error.output, {first.red(), first.green(), first.blue()},
        {second.red(), second.green(), second.blue()}, light.Rays(0), light.Rays(1)));
}

integral::BeamSamples::Seen IntegralTracer::Seen(const integral::BeamRay& ray,
                                                 const IntegralHit& hit) const
{
    const integral::LightFieldRay line = integral::light_field_ray(view->Lattice(), ray);
    return {line, hit.depth, Linear(hit.light), Tilt(line, hit)};
}

/// The tilt of the surface that a ray met along `line` (BeamSamples::Seen::tilt).
std::array<float, 2> IntegralTracer::Tilt(const integral::LightFieldRay& line,
                                          const IntegralHit& hit) const
{
    if (!(hit.depth < HUGE_VAL))
        return {};
    // A plane's normal is a covector: its components along the sheet's axes are dot products.
    const integral::Placement& placement = view->optics->placement;
    const integral::Lattice& lattice = view->Lattice();
    integral::Vec3 facing{dot(hit.normal, placement.x), dot(hit.normal, placement.y),
                          dot(hit.normal, placement.z)};
    if (view->optics->parallax)
        facing = image_of_normal(view->optics->relief, sheet_from_scene(placement, hit.point),
                                 facing);
    const integral::Vec2 lateral{facing.x, facing.y};
    const double across = dot(lateral, lattice.across()), along = dot(lateral, lattice.along()),
                 area = across * line.slope[0] + along * line.slope[1] + facing.z;
    return area < 0 || area > 0 ? std::array<float, 2>{float(across / area), float(along / area)}
                                : std::array<float, 2>{};
}

void IntegralLight::Add(const integral::PixelRay& ray, const Colour& seen)
{
    const int channel = ray.channel == integral::PixelRay::all_channels ? int(all) : ray.channel;
    rays[ray.half]++;
    sums[ray.half][channel] += seen * ray.weight;
    weights[ray.half][channel] += ray.weight;
}

void IntegralLight::Add(const IntegralLight& other)
{
    for (int half = 0; half < 2; half++)
    {
        rays[half] += other.rays[half];
        for (int channel = 0; channel < 4; channel++)
        {
            sums[half][channel] += other.sums[half][channel];
            weights[half][channel] += other.weights[half][channel];
        }
    }
}

Colour IntegralLight::Mean(int half) const
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

}
