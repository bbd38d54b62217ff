// SPDX-License-Identifier: AGPL-3.0-or-later
// Anti-aliasing (+A) of an integral camera, in two passes: every pixel's first sample; then more of
// those pixels that depart from their neighbours in the light field.
#ifndef POVRAY_BACKEND_INTEGRALSAMPLING_H
#define POVRAY_BACKEND_INTEGRALSAMPLING_H

#include <atomic>
#include <memory>
#include <vector>

#include "backend/frame.h"
#include "backend/render/integraltask.h"
#include "base/image/colourspace.h"
#include "base/integralmemory.h"
#include "base/integraloptions.h"
#include "integral/lightfield/refinement.h"

namespace pov
{

class Camera;

/// What the first pass leaves to the second; 36 bytes a pixel of the rows that need first samples.
/// In a file where that is more than POV-Ray would keep of an image in main memory.
class IntegralSampling
{
public:
    /// `rows` count; `side`: of the blocks that are refined, pixels. `most_memory`: bytes in main
    /// memory. Throws pov_base::Exception if there is no room.
    IntegralSampling(const integral::IntegralCamera& camera, const pov_base::IntegralRows& rows,
                     int side, std::size_t most_memory);

    /// The part of what is rendered that needs first samples: whole blocks, where they have rows
    /// that count, and what is looked at from there.
    POVRect Needed(const POVRect& rendered) const;

    /// The next block of the first pass; false once all of `area` has been given out.
    bool Next_Block(const POVRect& area, POVRect& block);

    /// To be called once a block has been sampled, or refined.
    void Done(const POVRect& block) { memory->Used(bytes_a_pixel * block.GetArea()); }

    integral::FirstSamples& First() { return first; }
    Colour& At(int x, int y) { return colours[std::size_t(y) * width + x]; }

private:
    static constexpr std::size_t bytes_a_pixel = 36;
    pov_base::IntegralRows rows;
    int width, height, side, reach;                   ///< reach: rows looked at, up or down
    std::shared_ptr<pov_base::IntegralMemory> memory; ///< the colours, then the first samples

    std::shared_ptr<pov_base::IntegralMemory> Memory(const integral::Film& film,
                                                     std::size_t most) const;
    integral::FirstSamples first;
    Colour *colours;
    std::atomic<unsigned int> next{0};
};

/// How many first-pass tasks a view with `threads` threads is to run before its frame is rendered:
/// none without +A.
int Integral_First_Pass_Tasks(const Camera& camera, unsigned int method, int threads);

/// One thread's share of the first pass, which shows the frame as it is without anti-aliasing.
class IntegralFirstPassTask : public IntegralTask
{
public:
    /// `continued`: some of the frame is there already, and its pixels are not to be shown as the
    /// first pass has them.
    IntegralFirstPassTask(ViewData *view, const GammaCurvePtr& gamma, bool reproducible,
                          bool continued);
    virtual void Run();

private:
    GammaCurvePtr gamma;
    bool reproducible, continued;
};

/// What a TraceTask's options say of anti-aliasing.
struct IntegralRefinementOptions
{
    integral::RefinementRule rule;
    GammaCurvePtr gamma;
    bool jitter, reproducible, final;
};

/// One thread's share of the second pass. False, with nothing done, if the view has had no first
/// pass.
bool Refine_Integral_View(ViewData& view, ViewThreadData& thread, TracePixel& trace,
                          RadiosityFunction& radiosity, Trace::CooperateFunctor& cooperate,
                          const IntegralRefinementOptions& options);

}

#endif
