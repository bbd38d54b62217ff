// SPDX-License-Identifier: AGPL-3.0-or-later
// Anti-aliases (+A) the frame of an integral camera in two passes: the first takes one sample of
// every pixel; the second takes more samples of pixels that differ from their neighbours in the
// light field.
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

/// The results of the first pass, for use in the second: 36 bytes per pixel of the rows that need
/// first samples. They are kept in a file if they exceed POV-Ray's limit for images in main memory.
class IntegralSampling
{
public:
    /// `rows`: the rows that count. `side`: width and height of the blocks that are refined,
    /// pixels. `most_memory`: limit of main memory, bytes. Throws pov_base::Exception if there is
    /// no room.
    IntegralSampling(const integral::IntegralCamera& camera, const pov_base::IntegralRows& rows,
                     int side, std::size_t most_memory);

    /// The part of the rendered area that needs first samples: all blocks with rows that count, and
    /// the neighbours of their pixels.
    POVRect Needed(const POVRect& rendered) const;

    /// Sets `block` to the next block of the first pass; false when all of `area` has been given
    /// out.
    bool Next_Block(const POVRect& area, POVRect& block);

    /// Reports that a block has been sampled or refined.
    void Done(const POVRect& block) { memory->Used(bytes_a_pixel * block.GetArea()); }

    integral::FirstSamples& First() { return first; }
    Colour& At(int x, int y) { return colours[std::size_t(y) * width + x]; }

private:
    static constexpr std::size_t bytes_a_pixel = 36;
    pov_base::IntegralRows rows;
    int width, height, side, reach;                   ///< reach: distance of neighbours, rows
    std::shared_ptr<pov_base::IntegralMemory> memory; ///< the colours, then the first samples

    std::shared_ptr<pov_base::IntegralMemory> Memory(const integral::Film& film,
                                                     std::size_t most) const;
    integral::FirstSamples first;
    Colour *colours;
    std::atomic<unsigned int> next{0};
};

/// The number of first-pass tasks that a view with `threads` threads must run before its frame is
/// rendered; 0 without +A.
int Integral_First_Pass_Tasks(const Camera& camera, unsigned int method, int threads);

/// One thread's share of the first pass. It also sends the frame without anti-aliasing to the
/// display.
class IntegralFirstPassTask : public IntegralTask
{
public:
    /// `continued`: part of the frame was rendered before (+C); the first pass must not overwrite
    /// its pixels on the display.
    IntegralFirstPassTask(ViewData *view, const GammaCurvePtr& gamma, bool reproducible,
                          bool continued);
    virtual void Run();

private:
    GammaCurvePtr gamma;
    bool reproducible, continued;
};

/// The anti-aliasing options of a TraceTask.
struct IntegralRefinementOptions
{
    integral::RefinementRule rule;
    GammaCurvePtr gamma;
    bool jitter, reproducible, final;
};

/// Runs one thread's share of the second pass. Does nothing and returns false if the view has had
/// no first pass.
bool Refine_Integral_View(ViewData& view, ViewThreadData& thread, TracePixel& trace,
                          RadiosityFunction& radiosity, Trace::CooperateFunctor& cooperate,
                          const IntegralRefinementOptions& options);

}

#endif
