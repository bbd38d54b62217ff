// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/render/integralrefinement.h"
#include "integral/reconstruction/split_half_error.h"

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

namespace
{

/// A ratio of sums of squared deviations; 0 where samples hardly differ.
double In_Linear_Light(double linear, double encoded)
{
    const double little = 1e-7;
    return encoded > little ? linear / encoded : 0;
}

}

IntegralRefinement::IntegralRefinement(ViewThreadData& thread, IntegralTracer& tracer,
                                       Trace::CooperateFunctor& cooperate,
                                       const IntegralRefinementOptions& options,
                                       const ComparedEncoding& compared, IntegralSampling& sampling)
    : thread(thread),
      tracer(tracer),
      beam(tracer),
      cooperate(cooperate),
      options(options),
      rule(options.rule),
      sampling(sampling),
      compared(compared)
{
    rule.lent = sampling.Lent() != NULL;
}

void IntegralRefinement::Run(const integral::PictureBlock& of)
{
    const double least = integral::least_contrast(rule);
    block = of;
    waiting.clear();
    expected.assign(std::size_t(Width()) * (block.bottom - block.top + 1), -1);
    for (int y = block.top; y <= block.bottom; y++)
        for (int x = block.left; x <= block.right; x++)
        {
            const double contrast = sampling.First().contrast(x, y);
            if (contrast >= least)
                Request(x, y, contrast);
            if (contrast >= 0)
                Keep(x, y, integral::squared_error_of_one(contrast));
        }
    for (std::size_t next = 0; next < waiting.size(); next++)
    {
        const int x = waiting[next].first, y = waiting[next].second;
        const integral::Refinement result = Refine(x, y);
        // The neighbours' first samples may have missed the edge that this pixel's samples found.
        if (result.scatter() >= least)
            sampling.First().for_each_neighbour(
                x, y, [&](int i, int j) { Request(i, j, result.contrast_shown()); });
    }
    if (integral::BeamSamples *const lent = sampling.Lent())
        lent->store(block.top, gathered);
}

int IntegralRefinement::Take_Extra(int x, int y, int begin, int number,
                                     integral::LinearColour& sum)
{
    int taken = 0;
    beam.Begin(x, y, !options.jitter, sampling.First());
    for (int index = begin; index < begin + number; index++)
    {
        const auto sample = Take(index, begin + number - index);
        if (!sample)
            continue;
        taken++;
        const integral::LinearColour light = Linear(sample->hit.light);
        for (std::size_t channel = 0; channel < light.size(); channel++)
            sum[channel] += light[channel];
    }
    return taken;
}

integral::Refinement IntegralRefinement::Refine(int x, int y)
{
    thread.Stats()[Number_Of_Pixels_Supersampled]++;
    integral::BeamSamples *const lent = sampling.Lent();
    integral::Refinement refinement(rule, expected[Index(x, y)]);
    integral::SplitHalfError halves;
    bool any = false;
    std::uint32_t index = 0;
    const Colour first = sampling.At(x, y);
    beam.Begin(x, y, !options.jitter, sampling.First());
    if (lent)
    {
        beam.Add(first);
        gathered.begin(x, y);
        refinement.add(compared(first));
        halves.add(Linear(first));
        thread.Stats()[Number_Of_Samples]++;
        index++;
    }
    while (const int requested = refinement.requested())
        for (int k = 0; k < requested; k++)
        {
            if (const auto sample = Take(index++, requested - k))
            {
                refinement.add(compared(sample->hit.light));
                halves.add(Linear(sample->hit.light));
                if (lent)
                    gathered.add(*lent, tracer.Seen(sample->ray, sample->hit));
                any = true;
            }
            else
            {
                refinement.add_none();
                halves.add_none();
            }
        }
    if (any)
    {
        sampling.At(x, y) = beam.Mean();
        Keep(x, y, refinement.squared_error(), halves.squared_error(compared.Curve()),
             refinement.samples(),
             In_Linear_Light(halves.squared_deviations(), refinement.squared_deviations()));
    }
    return refinement;
}

void IntegralRefinement::Keep(int x, int y, double squared_error, double squared_error_of_halves,
                              integral::SamplesTaken samples, double in_linear_light)
{
    if (integral::Reconstruction *const reconstruction = sampling.Reconstruction())
        reconstruction->set(x, y, Linear(sampling.At(x, y)), squared_error, squared_error_of_halves,
                            samples, in_linear_light);
}

}
