// SPDX-License-Identifier: AGPL-3.0-or-later
// Anti-aliases (+A) the frame of an integral camera in passes over all pixels: the first takes one
// sample of every pixel; the second takes more samples of pixels that differ from their neighbours
// in the light field; the third makes first estimates of the pixels from each other. With these the
// frame is reconstructed block by block.
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
#include "integral/lightfield/reconstruction.h"
#include "integral/lightfield/refinement.h"

namespace pov
{

class Camera;

/// The anti-aliasing options of a view.
struct IntegralRefinementOptions
{
    integral::RefinementRule rule;
    GammaCurvePtr gamma;
    bool jitter, reproducible;
};

/// The results of the passes: 36 bytes per pixel of the rows that need samples, and 20 more with
/// reconstruction. They are kept in a file if they exceed POV-Ray's limit for images in main
/// memory.
class IntegralSampling
{
public:
    enum Pass
    {
        first_pass,
        refinement,
        estimation,
        passes
    };

    /// `rows`: the rows that count. `side`: width and height of the blocks that are refined,
    /// pixels. `most_memory`: limit of main memory, bytes. `reconstructs`: whether the frame is to
    /// be reconstructed, if that is possible; `least_error`: see integral::Reconstruction. Throws
    /// pov_base::Exception if there is no room.
    IntegralSampling(const integral::IntegralCamera& camera, const pov_base::IntegralRows& rows,
                     int side, std::size_t most_memory, bool reconstructs, double least_error);

    /// The rows that a pass must work on, of the rendered area: for the second pass all blocks with
    /// rows that count or that the reconstruction of those needs; for the first also the neighbours
    /// of their pixels; for the third the neighbours of rows that count.
    POVRect Needed(const POVRect& rendered, Pass pass) const;

    /// Sets `block` to the next block of a pass over `area`; false when all has been given out.
    bool Next_Block(const POVRect& area, Pass pass, POVRect& block);

    /// Reports that a pass is done with a block.
    void Done(const POVRect& block) { memory->Used(Bytes_A_Pixel() * block.GetArea()); }

    /// The part of a block's progress that the passes have reported already, 0 to 1.
    float Progress(const POVRect& rendered, const POVRect& block) const;

    integral::FirstSamples& First() { return first; }
    /// Null: the frame is not reconstructed.
    integral::Reconstruction *Reconstruction() const { return reconstruction.get(); }
    Colour& At(int x, int y) { return colours[std::size_t(y) * width + x]; }

private:
    pov_base::IntegralRows rows;
    int width, height, side;
    bool reconstructs;
    int reach, halo; ///< rows to a pixel's neighbours, and to those that its reconstruction needs
    std::shared_ptr<pov_base::IntegralMemory> memory; ///< colours, first samples, reconstruction
    integral::FirstSamples first;
    std::unique_ptr<integral::Reconstruction> reconstruction;
    Colour *colours;
    std::atomic<unsigned int> next[passes] = {};

    std::size_t Bytes_A_Pixel() const;
    std::shared_ptr<pov_base::IntegralMemory> Memory(const integral::Film& film,
                                                     std::size_t most) const;
    std::shared_ptr<void> Part(std::size_t pixels_before, const integral::Film& film) const;
};

/// The number of passes that a view must run before its frame is rendered, each with as many tasks
/// as there are threads, and each after the one before has ended; 0 without +A.
int Integral_Passes(const Camera& camera, unsigned int method);

/// One thread's share of a pass. The first also sends the frame without anti-aliasing to the
/// display.
class IntegralSamplingTask : public IntegralTask
{
public:
    /// `continued`: part of the frame was rendered before (+C); the passes must not overwrite its
    /// pixels on the display.
    IntegralSamplingTask(ViewData *view, int pass, const IntegralRefinementOptions& options,
                         bool continued);
    virtual void Run();

private:
    template <class Compared> void Sample(const POVRect& block, const Compared& compared);
    void Show(const POVRect& block, float share);

    IntegralSampling::Pass pass;
    IntegralRefinementOptions options;
    bool continued;
    std::vector<Colour> pixels;
};

/// Reconstructs the blocks of a thread's share of the frame and hands them over; `final`: as
/// finished. Does nothing and returns false if the view has had no passes.
bool Reconstruct_Integral_View(ViewData& view, ViewThreadData& thread,
                               Trace::CooperateFunctor& cooperate, const GammaCurvePtr& gamma,
                               bool final);

}

#endif
