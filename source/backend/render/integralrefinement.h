// SPDX-License-Identifier: AGPL-3.0-or-later
// The second pass of anti-aliasing (integralsampling.h): takes more samples of the pixels of a
// block that differ from their neighbours in the light field. Also takes the extra samples that
// reconstruction requests.
#ifndef POVRAY_BACKEND_INTEGRALREFINEMENT_H
#define POVRAY_BACKEND_INTEGRALREFINEMENT_H

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "backend/frame.h"
#include "backend/render/integralcolours.h"
#include "backend/render/integralsamplers.h"
#include "backend/render/integralsampling.h"
#include "backend/scene/scene.h"
#include "backend/scene/view.h"

namespace pov
{

/// One thread's refinement.
class IntegralRefinement
{
public:
    /// Refers to all of these, which must outlive it.
    IntegralRefinement(ViewThreadData& thread, IntegralTracer& tracer,
                       Trace::CooperateFunctor& cooperate, const IntegralRefinementOptions& options,
                       const ComparedEncoding& compared, IntegralSampling& sampling);

    /// Refines the pixels of a block. First samples must have been taken in it and around it.
    void Run(const integral::PictureBlock& of);

    /// Implements integral::Reconstruction::ExtraSamples::take.
    int Take_Extra(int x, int y, int begin, int number, integral::LinearColour& sum);

private:
    int Width() const { return block.right - block.left + 1; }
    std::size_t Index(int x, int y) const
    {
        return std::size_t(y - block.top) * Width() + (x - block.left);
    }

    /// Queues a pixel for refinement, if it is one of the block's, with the contrast expected from
    /// its neighbours.
    void Request(int x, int y, double contrast)
    {
        if (x < block.left || x > block.right || y < block.top || y > block.bottom)
            return;
        double& most = expected[Index(x, y)];
        if (most < 0)
            waiting.emplace_back(x, y);
        most = std::max(most, contrast);
    }

    /// Traces one sample of the beam (IntegralBeam::Trace).
    std::optional<IntegralSample> Take(std::uint32_t index, int number)
    {
        const std::optional<IntegralSample> sample = beam.Trace(index, number);
        thread.Stats()[Number_Of_Samples]++;
        cooperate();
        return sample;
    }

    integral::Refinement Refine(int x, int y);
    void Keep(int x, int y, double squared_error, double squared_error_of_halves = -1,
              integral::SamplesTaken samples = {}, double in_linear_light = 0);

    ViewThreadData& thread;
    IntegralTracer& tracer;
    IntegralBeam beam; ///< of the pixel that is being refined
    Trace::CooperateFunctor& cooperate;
    const IntegralRefinementOptions& options;
    integral::RefinementRule rule;
    IntegralSampling& sampling;
    const ComparedEncoding& compared;
    integral::PictureBlock block;
    std::vector<double> expected; ///< the contrast of each pixel in `waiting`, -1 elsewhere
    std::vector<std::pair<int, int>> waiting;
    integral::BeamSamples::Gathered gathered;
};

}

#endif
