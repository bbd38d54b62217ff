// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/render/integralsampling.h"
#include "backend/scene/camera.h"
#include "backend/scene/integralcamera.h"
#include "backend/scene/scene.h"
#include "backend/scene/view.h"
#include "integral/lightfield/tabulated_curve.h"

#include <algorithm>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

namespace
{

constexpr unsigned int sampled_block = 32, estimated_block = 64; // pixels across and down
// The shares of the passes in the displayed progress; the rest is the reconstruction's.
constexpr float first_share = 0.4f, refinement_share = 0.5f;

/// Converts a colour to the encoding in which anti-aliasing compares colours.
class ComparedEncoding
{
public:
    explicit ComparedEncoding(const GammaCurvePtr& gamma)
        : curve([&](float value) { return GammaCurve::Encode(gamma, value); })
    {
    }
    integral::ComparedColour operator()(const Colour& colour) const
    {
        return {curve(colour.red()), curve(colour.green()), curve(colour.blue()), colour.transm()};
    }

private:
    integral::TabulatedCurve curve;
};

IntegralSampling *Sampling_Of(const Camera& camera)
{
    return camera.Integral_View ? camera.Integral_View->sampling.get() : NULL;
}

}

IntegralSampling::IntegralSampling(const integral::IntegralCamera& camera,
                                   const pov_base::IntegralRows& rows, int side,
                                   std::size_t most_memory, bool reconstructs,
                                   double least_error)
    : rows(rows),
      width(camera.film.width),
      height(camera.film.height),
      side(side),
      reconstructs(reconstructs && integral::Reconstruction::possible(camera.film)),
      reach(integral::rows_looked_at(camera.optics.sheet(), camera.film)),
      halo(this->reconstructs
               ? integral::rows_reconstructed_from(camera.optics.sheet(), camera.film)
               : 0),
      memory(Memory(camera.film, most_memory)),
      first(camera, Part(sizeof(Colour), camera.film)),
      colours(reinterpret_cast<Colour *>(memory->Data()))
{
    if (this->reconstructs)
        reconstruction.reset(new integral::Reconstruction(
            camera, first, least_error,
            Part(sizeof(Colour) + integral::FirstSamples::bytes_a_pixel, camera.film)));
}

std::size_t IntegralSampling::Bytes_A_Pixel() const
{
    return sizeof(Colour) + integral::FirstSamples::bytes_a_pixel +
           (reconstructs ? integral::Reconstruction::bytes_a_pixel : 0);
}

std::shared_ptr<pov_base::IntegralMemory> IntegralSampling::Memory(const integral::Film& film,
                                                                   std::size_t most) const
{
    const POVRect needed = Needed(POVRect(0, 0, width - 1, height - 1), first_pass);
    const std::size_t pixels = std::size_t(width) * height, above = std::size_t(width) * needed.top,
                      below = std::size_t(width) * (needed.bottom + 1);
    const bool in_file = Bytes_A_Pixel() * (below - above) > most;
    auto memory = std::make_shared<pov_base::IntegralMemory>(Bytes_A_Pixel() * pixels, in_file);
    std::size_t begin = 0;
    for (std::size_t bytes :
         {sizeof(Colour), integral::FirstSamples::bytes_a_pixel, integral::Reconstruction::bytes_a_pixel})
    {
        if (begin + bytes > Bytes_A_Pixel())
            break;
        memory->Reserve(begin * pixels + bytes * above, begin * pixels + bytes * below);
        begin += bytes;
    }
    return memory;
}

/// The part of the memory that begins after that many bytes per pixel.
std::shared_ptr<void> IntegralSampling::Part(std::size_t bytes_before,
                                             const integral::Film& film) const
{
    return {memory, memory->Data() + bytes_before * film.width * film.height};
}

POVRect IntegralSampling::Needed(const POVRect& rendered, Pass pass) const
{
    const int top = rendered.top, bottom = rendered.bottom;
    const auto in_it = [&](int y) { return std::min(std::max(y, top), bottom); };
    const int first_row = in_it(rows.first - std::min(rows.first, halo)),
              last_row = in_it(std::min(rows.last, bottom) + halo);
    POVRect needed = rendered;
    if (pass == estimation)
    {
        needed.top = in_it(rows.first - std::min(rows.first, reach));
        needed.bottom = in_it(std::min(rows.last, bottom) + reach);
        return needed;
    }
    const int around = pass == first_pass ? reach : 0;
    needed.top = in_it(top + (first_row - top) / side * side - around);
    needed.bottom = in_it(top + ((last_row - top) / side + 1) * side - 1 + around);
    return needed;
}

bool IntegralSampling::Next_Block(const POVRect& area, Pass pass, POVRect& block)
{
    const unsigned int length = pass == refinement   ? side
                                : pass == estimation ? estimated_block
                                                     : sampled_block;
    const unsigned int across = (area.GetWidth() + length - 1) / length, index = next[pass]++;
    block.left = area.left + (index % across) * length;
    block.top = area.top + (index / across) * length;
    block.right = std::min(block.left + length - 1, area.right);
    block.bottom = std::min(block.top + length - 1, area.bottom);
    return block.top <= area.bottom;
}

float IntegralSampling::Progress(const POVRect& rendered, const POVRect& block) const
{
    const auto part = [&](Pass pass)
    {
        const POVRect needed = Needed(rendered, pass);
        const int rows = int(std::min(block.bottom, needed.bottom)) -
                         int(std::max(block.top, needed.top)) + 1;
        return float(std::max(0, rows)) / block.GetHeight();
    };
    return first_share * part(first_pass) + refinement_share * part(refinement);
}

int Integral_Passes(const Camera& camera, unsigned int method)
{
    IntegralSampling *const sampling = method > 0 ? Sampling_Of(camera) : NULL;
    if (!sampling)
        return 0;
    return sampling->Reconstruction() ? IntegralSampling::passes : IntegralSampling::passes - 1;
}

namespace
{

/// The second pass over one block.
class BlockRefinement
{
public:
    BlockRefinement(ViewData& view, ViewThreadData& thread, TracePixel& trace,
                    const IntegralRefinementOptions& options, const ComparedEncoding& compared,
                    IntegralSampling& sampling)
        : view(view),
          thread(thread),
          trace(trace),
          options(options),
          sampling(sampling),
          compared(compared)
    {
    }

    /// Refines the block's pixels. Calls `cooperate` after each.
    template <class Cooperate> void Run(const POVRect& of, Cooperate cooperate)
    {
        block = of;
        waiting.clear();
        refined.assign(block.GetArea(), false);
        for (int y = block.top; y <= int(block.bottom); y++)
            for (int x = block.left; x <= int(block.right); x++)
            {
                const double contrast = sampling.First().contrast(x, y);
                if (contrast >= options.rule.threshold)
                    Want(x, y);
                if (contrast >= 0)
                    Keep(x, y, integral::squared_error_of_one(contrast));
            }
        for (std::size_t next = 0; next < waiting.size(); next++)
        {
            const int x = waiting[next].first, y = waiting[next].second;
            const bool busy = Refine(x, y);
            cooperate();
            if (busy) // its neighbours' first samples may have missed the same edge
                sampling.First().for_each_neighbour(x, y, [&](int i, int j) { Want(i, j); });
        }
    }

private:
    std::size_t Index(int x, int y) const
    {
        return std::size_t(y - block.top) * block.GetWidth() + (x - block.left);
    }

    void Want(int x, int y)
    {
        if (x < int(block.left) || x > int(block.right) || y < int(block.top) ||
            y > int(block.bottom) || refined[Index(x, y)])
            return;
        refined[Index(x, y)] = true;
        waiting.emplace_back(x, y);
    }

    /// Refines a pixel. Returns whether its samples differ so much that its neighbours should be
    /// refined too.
    bool Refine(int x, int y)
    {
        thread.Stats()[Number_Of_Pixels_Supersampled]++;
        trace.Integral().Refine(x, y, !options.jitter, sampling.First().depth(x, y));
        integral::Refinement refinement(options.rule, sampling.First().contrast(x, y));
        bool any = false;
        std::uint32_t index = 0;
        while (const int wanted = refinement.wanted())
            for (int k = 0; k < wanted; k++)
            {
                Colour seen;
                trace.Integral().Take(index++);
                trace(x, y, view.GetWidth(), view.GetHeight(), seen);
                if (trace.Integral().Imaged())
                    refinement.add(compared(seen));
                else
                    refinement.add_none();
                any = any || trace.Integral().Imaged();
                thread.Stats()[Number_Of_Samples]++;
            }
        if (any)
        {
            sampling.At(x, y) = trace.Integral().Refined();
            Keep(x, y, refinement.squared_error());
        }
        trace.Integral().End_Refinement();
        return refinement.scatter() >= options.rule.threshold;
    }

    void Keep(int x, int y, double squared_error)
    {
        if (integral::Reconstruction *const reconstruction = sampling.Reconstruction())
            reconstruction->set(x, y, compared(sampling.At(x, y)), squared_error);
    }

    ViewData& view;
    ViewThreadData& thread;
    TracePixel& trace;
    const IntegralRefinementOptions& options;
    IntegralSampling& sampling;
    const ComparedEncoding& compared;
    POVRect block;
    std::vector<bool> refined; ///< true also for pixels in `waiting`
    std::vector<std::pair<int, int>> waiting;
};

}

IntegralSamplingTask::IntegralSamplingTask(ViewData *view, int pass,
                                           const IntegralRefinementOptions& options, bool continued)
    : IntegralTask(view, true),
      pass(IntegralSampling::Pass(pass)),
      options(options),
      continued(continued)
{
}

/// Takes the first samples of a block. `compared` converts a colour for comparison.
template <class Compared>
void IntegralSamplingTask::Sample(const POVRect& block, const Compared& compared)
{
    const ViewData& view = *GetViewData();
    IntegralSampling& sampling = *Sampling_Of(view.GetCamera());
    for (unsigned int y = block.top; y <= block.bottom; y++)
        for (unsigned int x = block.left; x <= block.right; x++)
        {
            Colour& colour = sampling.At(x, y);
            trace(x, y, view.GetWidth(), view.GetHeight(), colour);
            GetViewDataPtr()->Stats()[Number_Of_Pixels]++;
            if (trace.Integral().Imaged())
                sampling.First().set(x, y, compared(colour), trace.Integral().Lens(),
                                     trace.Integral().Depth());
            Cooperate();
        }
}

/// Sends a block as it is now to the display, and adds `share` of it to the progress.
void IntegralSamplingTask::Show(const POVRect& block, float share)
{
    IntegralSampling& sampling = *Sampling_Of(GetViewData()->GetCamera());
    pixels.clear();
    for (unsigned int y = block.top; y <= block.bottom; y++)
        for (unsigned int x = block.left; x <= block.right; x++)
            pixels.push_back(sampling.At(x, y));
    if (!continued)
        GetViewData()->CompletedRectangle(block, 0, pixels, 1, false, share);
}

void IntegralSamplingTask::Run()
{
    ViewData& view = *GetViewData();
    IntegralSampling& sampling = *Sampling_Of(view.GetCamera());
    const POVRect area = sampling.Needed(view.GetRenderArea(), pass);
    const ComparedEncoding compared(options.gamma);
    BlockRefinement refinement(view, *GetViewDataPtr(), trace, options, compared, sampling);
    POVRect block;
    while (sampling.Next_Block(area, pass, block))
    {
        radiosity.BeforeTile(options.reproducible ? block.top * view.GetWidth() + block.left : 0);
        if (pass == IntegralSampling::first_pass)
            Sample(block, compared);
        else if (pass == IntegralSampling::refinement)
            refinement.Run(block, [this] { Cooperate(); });
        else
            sampling.Reconstruction()->estimate(block.left, block.top, block.right, block.bottom);
        sampling.Done(block);
        radiosity.AfterTile();
        GetViewDataPtr()->AfterTile();
        if (pass == IntegralSampling::first_pass)
            Show(block, first_share);
        else if (pass == IntegralSampling::refinement)
            Show(block, refinement_share);
        Cooperate();
    }
    view.SetHighestTraceLevel(trace.GetHighestTraceLevel());
}

namespace
{

void Reconstruct(const integral::Reconstruction& reconstruction, const GammaCurvePtr& gamma, int x,
                 int y, integral::Reconstruction::Scratch& scratch, Colour& colour)
{
    const auto reconstructed = reconstruction.reconstructed(x, y, scratch);
    if (!reconstructed)
        return;
    for (int k = 0; k < 3; k++)
        colour[k] = GammaCurve::Decode(gamma, float((*reconstructed)[k]));
    colour.transm() = float((*reconstructed)[3]);
}

}

bool Reconstruct_Integral_View(ViewData& view, ViewThreadData& thread,
                               Trace::CooperateFunctor& cooperate, const GammaCurvePtr& gamma,
                               bool final)
{
    IntegralSampling *const sampling = Sampling_Of(view.GetCamera());
    if (!sampling)
        return false;

    const pov_base::IntegralRows& rows = view.GetCamera().Integral_View->rows;
    integral::Reconstruction::Scratch scratch;
    POVRect block;
    unsigned int serial;
    std::vector<Colour> pixels;
    while (view.GetNextRectangle(block, serial))
    {
        pixels.clear();
        for (int y = block.top; y <= int(block.bottom); y++)
            for (int x = block.left; x <= int(block.right); x++)
            {
                pixels.push_back(sampling->At(x, y));
                if (sampling->Reconstruction() && rows.Have(y))
                    Reconstruct(*sampling->Reconstruction(), gamma, x, y, scratch, pixels.back());
            }
        sampling->Done(block);
        thread.AfterTile();
        // A block without rows that count is never marked final, so that +C may be used with other
        // rows.
        const bool counts = rows.Meet(block.top, block.bottom);
        view.CompletedRectangle(block, serial, pixels, 1, final && counts,
                                1 - sampling->Progress(view.GetRenderArea(), block));
        cooperate();
    }
    return true;
}

}
