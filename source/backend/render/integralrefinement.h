// SPDX-License-Identifier: AGPL-3.0-or-later
// The second pass of anti-aliasing (integralsampling.h): takes more samples of the pixels of a
// block that differ from their neighbours in the light field. And takes the further samples that
// reconstruction asks for.
#ifndef POVRAY_BACKEND_INTEGRALREFINEMENT_H
#define POVRAY_BACKEND_INTEGRALREFINEMENT_H

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "backend/frame.h"
#include "backend/render/integralcolours.h"
#include "backend/render/integralsampling.h"
#include "backend/scene/scene.h"
#include "backend/scene/view.h"

namespace pov
{

/// One thread's.
class IntegralRefinement
{
public:
    /// Refers to all of these, which must outlive it.
    IntegralRefinement(ViewData& view, ViewThreadData& thread, TracePixel& trace,
                       Trace::CooperateFunctor& cooperate, const IntegralRefinementOptions& options,
                       const ComparedEncoding& compared, IntegralSampling& sampling);

    /// Refines the pixels of a block, of which first samples have been taken, also around it.
    void Run(const integral::PictureBlock& of);

    /// integral::Reconstruction::Further::take
    int Take_Further(int x, int y, int begin, int number, integral::LinearColour& sum);

private:
    int Width() const { return block.right - block.left + 1; }
    std::size_t Index(int x, int y) const
    {
        return std::size_t(y - block.top) * Width() + (x - block.left);
    }

    /// Has a pixel refined, if it is one of the block's. `contrast`: what its surroundings let
    /// expect.
    void Want(int x, int y, double contrast)
    {
        if (x < block.left || x > block.right || y < block.top || y > block.bottom)
            return;
        double& most = expected[Index(x, y)];
        if (most < 0)
            waiting.emplace_back(x, y);
        most = std::max(most, contrast);
    }

    /// Traces one sample of the pixel that is being refined, the first of `number` that are to be
    /// taken one after the other. Returns whether it belongs to the pixel's lens.
    bool Take(int x, int y, std::uint32_t index, int number, Colour& seen)
    {
        trace.Integral().Take(index, number);
        trace(x, y, view.GetWidth(), view.GetHeight(), seen);
        thread.Stats()[Number_Of_Samples]++;
        cooperate();
        return trace.Integral().Imaged();
    }

    integral::Refinement Refine(int x, int y);
    void Keep(int x, int y, double squared_error, double squared_error_of_halves = -1,
              integral::SamplesTaken samples = {}, double in_linear_light = 0);

    ViewData& view;
    ViewThreadData& thread;
    TracePixel& trace;
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
