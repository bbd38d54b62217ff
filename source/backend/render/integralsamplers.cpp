// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/render/integralsamplers.h"
#include "backend/scene/integralcamera.h"

#include <algorithm>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

std::optional<IntegralFirstSamples::Pixel> IntegralFirstSamples::Trace(int x, int y)
{
    const IntegralView& view = tracer.View();
    if (view.quilt)
        return Trace_Of_View(x, y);
    if (y != run_y || x < run_x || x >= run_x + integral::run_length)
    {
        run_x = x;
        run_y = y;
        const integral::Vec2 centre{x + 0.5, y + 0.5};
        integral::map_pixel_run(*view.sampled_optics, centre, run);
        view.sampled_sampler->first_samples(centre, run.mapped, same_pattern, samples);
    }
    const integral::MappedPoint& mapped = run.mapped[x - run_x];
    const integral::PixelOutcome outcome = integral::outcome_of(mapped);
    tracer.Count(outcome, outcome.imaged);
    if (!mapped.ray)
        return std::nullopt;
    const integral::BeamRay& ray = samples[x - run_x];
    tracer.Begin_Sample(x, y, 0);
    return Pixel{outcome.lens, integral::pole_beam(*mapped.ray), {tracer.Trace(ray), ray}};
}

std::optional<IntegralFirstSamples::Pixel> IntegralFirstSamples::Trace_Of_View(int x, int y)
{
    const integral::QuiltSampler& quilt = *tracer.View().quilt;
    const integral::PixelOutcome outcome = quilt.outcome(x, y);
    tracer.Count(outcome, outcome.imaged);
    if (!outcome.imaged)
        return std::nullopt;
    const integral::BeamRay ray = *quilt.sample(x, y, same_pattern, 0);
    tracer.Begin_Sample(x, y, 0);
    return Pixel{outcome.lens, *quilt.ray({x + 0.5, y + 0.5}), {tracer.Trace(ray), ray}};
}

void IntegralBeam::Begin(int at_x, int at_y, bool same_pattern,
                         const integral::LightFieldImage& image)
{
    const IntegralView& view = tracer.View();
    x = at_x;
    y = at_y;
    light = IntegralLight();
    of_same_pattern = same_pattern;
    if (view.quilt)
        return;
    std::optional<integral::LensIndex> around;
    if (view.sampled_optics->film.subpixels == integral::Subpixels::none)
        around = image.lens_around(x, y);
    beam = view.sampled_sampler->beam({x + 0.5, y + 0.5}, same_pattern, image.depth(x, y), around);
    run_begin = run_end = 0;
}

/// Sets `rays` to the rays of a sample: one for each channel; none if another lens images it.
void IntegralBeam::Append_Rays(std::uint32_t index, int number)
{
    const integral::PixelSampler& sampler = *tracer.View().sampled_sampler;
    rays.clear();
    if (const auto& quilt = tracer.View().quilt)
        return rays.push_back({*quilt->sample(x, y, of_same_pattern, index)});
    if (beam.number != 1)
        return sampler.append_sample(beam, index, rays);
    if (index < run_begin || index >= run_end)
    {
        number = std::min(number, integral::run_length);
        sampler.samples(beam.channels[0], index, number, run);
        run_begin = index;
        run_end = index + number;
    }
    if (const auto& ray = run[index - run_begin])
        rays.push_back({*ray, 1, beam.channels[0].channel});
}

std::optional<IntegralSample> IntegralBeam::Trace(std::uint32_t index, int number)
{
    Append_Rays(index, number);
    tracer.Count({}, rays.size());
    if (rays.empty())
        return std::nullopt;
    tracer.Begin_Sample(x, y, index);
    IntegralLight of_sample;
    const IntegralHit hit = tracer.Trace(rays, of_sample);
    light.Add(of_sample);
    return IntegralSample{hit, rays.back().ray};
}

Colour Trace_Integral_Reference(IntegralTracer& tracer, int x, int y, std::uint64_t set,
                                std::uint32_t index, std::vector<integral::PixelRay>& rays)
{
    rays.clear();
    tracer.Begin_Reference(x, y, set, index);
    IntegralLight light;
    if (const auto& quilt = tracer.View().quilt)
    {
        if (const auto ray = quilt->reference(x, y, set, index))
            return tracer.Trace(*ray).light;
        return IntegralPixel::Without_Light().colour;
    }
    return tracer.View().sampler->append_reference_ray({x + 0.5, y + 0.5}, set, index, rays)
               ? tracer.Trace(rays, light).light
               : IntegralPixel::Without_Light().colour;
}

}
