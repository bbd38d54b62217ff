// SPDX-License-Identifier: AGPL-3.0-or-later
// Anti-aliases (+A) the frame of an integral camera in passes over its blocks: the first takes one sample of
// every pixel; the second takes more samples of pixels that differ from their neighbours in the light field;
// two more reconstruct the frame from the samples of all pixels, and the last lowers the noise that
// reconstruction leaves.
#ifndef POVRAY_BACKEND_INTEGRALSAMPLING_H
#define POVRAY_BACKEND_INTEGRALSAMPLING_H

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "backend/frame.h"
#include "backend/render/tracepixel.h"
#include "base/image/colourspace.h"
#include "base/integralmemory.h"
#include "base/integraloptions.h"
#include "integral/reconstruction/noise_filter.h"
#include "integral/reconstruction/pass_rows.h"
#include "integral/reconstruction/pass_schedule.h"
#include "integral/reconstruction/reconstruction.h"
#include "integral/reconstruction/refinement.h"

namespace pov
{

class RadiosityFunction;
class ViewData;
class ViewThreadData;

/// The anti-aliasing options of a view.
struct IntegralRefinementOptions
{
    integral::RefinementRule rule;
    GammaCurvePtr gamma;
    bool jitter, reproducible, final;
};

/// The results of the passes: 36 bytes per pixel, and 102 more with reconstruction, of the rows
/// that a pass still needs. Further samples take 32 bytes each, at most 15 a pixel, until layers
/// have been estimated from them.
class IntegralSampling
{
public:
    enum Pass
    {
        sampling,
        refinement,
        estimation,
        reconstruction,
        filtering
    };
    /// The shares of the passes in the displayed progress; reconstruction and the noise filter have the
    /// remaining share.
    static constexpr float sampling_share = 0.4f, refinement_share = 0.5f;

    /// `quilt`: of the picture; nothing: it is a frame. `rows`: the rows that count. `side`: width
    /// and height of the view's blocks, pixels. `reconstructs`: whether the frame is to be
    /// reconstructed, if that is possible; `least_error`: see integral::Reconstruction.
    /// `displayed`: whether the picture is displayed while it is rendered. Throws
    /// pov_base::Exception if the address space is too small.
    IntegralSampling(const integral::IntegralCamera& camera,
                     const std::optional<integral::QuiltGeometry>& quilt,
                     const pov_base::IntegralRows& rows, int side, bool reconstructs,
                     double least_error, bool displayed);

    /// Takes the blocks of the view that are to be rendered, and makes the schedule of all passes.
    /// Later calls have no effect. Any thread may call it.
    void Begin(ViewData& view);
    integral::PassSchedule& Schedule() { return *schedule; }

    /// Whether a block of the last pass is to be rendered; if so, sets `serial` to its number.
    bool Is_Wanted(const integral::PictureBlock& block, unsigned int& serial) const;

    /// Whether the progress of a block is reported before its last pass: not if an earlier render
    /// finished it (+C).
    bool Reports(const integral::PictureBlock& block) const;

    /// Whether the block's unfinished pixels are handed over, too.
    bool Is_Displayed() const { return displayed; }

    /// The whole block of the view that contains `part`, the piece on which a pass works.
    integral::PictureBlock Whole(const integral::PictureBlock& part) const;

    int Last_Pass() const { return int(scheduled.size()) - 1; }

    /// The progress (0 to 1) that the passes before the last report for a block.
    float Progress(const integral::PictureBlock& block) const;

    /// Releases the memory of rows that no pass needs any more. Call it after PassSchedule::finish.
    void Release();

    integral::LightFieldImage& First() { return first; }
    /// Null: the frame is not reconstructed.
    integral::Reconstruction *Reconstruction() const { return reconstructor.get(); }
    /// Null: the frame is not reconstructed.
    const integral::NoiseFilter *Filter() const { return filter.get(); }
    /// The samples that pixels share; null if the frame is not reconstructed.
    integral::BeamSamples *Lent() const { return lent.get(); }
    Colour& At(int x, int y) { return colours[std::size_t(y) * width + x]; }

private:
    pov_base::IntegralRows rows;
    int width, height, side;
    bool reconstructs, displayed;
    integral::PassRows pass_rows;
    std::vector<std::size_t> parts; ///< bytes a pixel of each part of the memory
    std::shared_ptr<pov_base::IntegralMemory> memory;
    integral::LightFieldImage first;
    std::unique_ptr<integral::BeamSamples> lent;
    std::unique_ptr<integral::Reconstruction> reconstructor;
    std::unique_ptr<integral::NoiseFilter> filter;
    Colour *colours;
    std::mutex mutex;                  ///< guards Begin and Release
    std::vector<std::size_t> released; ///< of each part of the memory: where to begin the next
                                       ///< release
    POVRect area;                      ///< the rendered part of the frame
    std::map<std::pair<int, int>, unsigned int> serials; ///< of the blocks to be rendered, by left
                                                         ///< and top
    std::unique_ptr<integral::PassSchedule> schedule;
    std::vector<integral::SchedulePass> scheduled; ///< the passes, as the schedule has them

    void Make_Schedule();
    std::size_t Begin_Of(std::size_t part) const;
    std::shared_ptr<void> Part(std::size_t number) const;
};

/// Runs one thread's share of the passes. `final`: hand the blocks over as finished. Does nothing
/// and returns false if the view is not anti-aliased in the light field.
bool Antialias_Integral_View(ViewData& view, ViewThreadData& thread, TracePixel& trace,
                             RadiosityFunction& radiosity, Trace::CooperateFunctor& cooperate,
                             const IntegralRefinementOptions& options);

}

#endif
