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

constexpr unsigned int block_side = 32;
constexpr float pass_share = 0.5f; // the first pass's share of the displayed progress

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

/// The offset of the first samples, which follow the colours.
std::size_t First_Samples_At(const integral::Film& film)
{
    return sizeof(Colour) * film.width * film.height;
}

IntegralSampling *Sampling_Of(const Camera& camera)
{
    return camera.Integral_View ? camera.Integral_View->sampling.get() : NULL;
}

}

IntegralSampling::IntegralSampling(const integral::IntegralCamera& camera,
                                   const pov_base::IntegralRows& rows, int side,
                                   std::size_t most_memory)
    : rows(rows),
      width(camera.film.width),
      height(camera.film.height),
      side(side),
      reach(integral::rows_looked_at(camera.optics.sheet(), camera.film)),
      memory(Memory(camera.film, most_memory)),
      first(camera, std::shared_ptr<void>(memory, memory->Data() + First_Samples_At(camera.film))),
      colours(reinterpret_cast<Colour *>(memory->Data()))
{
}

std::shared_ptr<pov_base::IntegralMemory> IntegralSampling::Memory(const integral::Film& film,
                                                                   std::size_t most) const
{
    const std::size_t top = std::max(0LL, (long long)rows.first - side - reach);
    const std::size_t end = std::min<long long>(height, (long long)rows.last + side + reach + 1);
    const std::size_t samples = First_Samples_At(film),
                      row = integral::FirstSamples::bytes(film) / height;
    const bool in_file = bytes_a_pixel * width * (end - top) > most;
    auto memory = std::make_shared<pov_base::IntegralMemory>(samples + row * height, in_file);
    memory->Reserve(top * width * sizeof(Colour), end * width * sizeof(Colour));
    memory->Reserve(samples + top * row, samples + end * row);
    return memory;
}

POVRect IntegralSampling::Needed(const POVRect& rendered) const
{
    const int top = rendered.top, bottom = rendered.bottom;
    const auto block = [&](int y) { return (std::min(std::max(y, top), bottom) - top) / side; };
    POVRect needed = rendered;
    needed.top = std::max(top, top + block(rows.first) * side - reach);
    needed.bottom = std::min(bottom, top + (block(rows.last) + 1) * side - 1 + reach);
    return needed;
}

bool IntegralSampling::Next_Block(const POVRect& area, POVRect& block)
{
    const unsigned int across = (area.GetWidth() + block_side - 1) / block_side, index = next++;
    block.left = area.left + (index % across) * block_side;
    block.top = area.top + (index / across) * block_side;
    block.right = std::min(block.left + block_side - 1, area.right);
    block.bottom = std::min(block.top + block_side - 1, area.bottom);
    return block.top <= area.bottom;
}

int Integral_First_Pass_Tasks(const Camera& camera, unsigned int method, int threads)
{
    return method > 0 && Sampling_Of(camera) ? threads : 0;
}

IntegralFirstPassTask::IntegralFirstPassTask(ViewData *view, const GammaCurvePtr& gamma,
                                             bool reproducible, bool continued)
    : IntegralTask(view, true), gamma(gamma), reproducible(reproducible), continued(continued)
{
}

void IntegralFirstPassTask::Run()
{
    ViewData& view = *GetViewData();
    IntegralSampling& sampling = *view.GetCamera().Integral_View->sampling;
    const POVRect area = sampling.Needed(view.GetRenderArea());
    POVRect block;
    std::vector<Colour> pixels;
    const ComparedEncoding compared(gamma);
    while (sampling.Next_Block(area, block))
    {
        radiosity.BeforeTile(reproducible ? block.top * view.GetWidth() + block.left : 0);
        pixels.clear();
        for (unsigned int y = block.top; y <= block.bottom; y++)
            for (unsigned int x = block.left; x <= block.right; x++)
            {
                Colour& colour = sampling.At(x, y);
                trace(x, y, view.GetWidth(), view.GetHeight(), colour);
                GetViewDataPtr()->Stats()[Number_Of_Pixels]++;
                if (trace.Integral().Imaged())
                    sampling.First().set(x, y, compared(colour), trace.Integral().Lens(),
                                         trace.Integral().Depth());
                pixels.push_back(colour);
                Cooperate();
            }
        sampling.Done(block);
        radiosity.AfterTile();
        GetViewDataPtr()->AfterTile();
        if (!continued)
            view.CompletedRectangle(block, 0, pixels, 1, false, pass_share);
        Cooperate();
    }
    view.SetHighestTraceLevel(trace.GetHighestTraceLevel());
}

namespace
{

/// The second pass over one block.
class BlockRefinement
{
public:
    BlockRefinement(ViewData& view, ViewThreadData& thread, TracePixel& trace,
                    Trace::CooperateFunctor& cooperate, const IntegralRefinementOptions& options,
                    IntegralSampling& sampling)
        : view(view),
          thread(thread),
          trace(trace),
          cooperate(cooperate),
          options(options),
          sampling(sampling),
          compared(options.gamma)
    {
    }

    /// Writes the block's pixels, row by row, to `pixels`. If not `counts`, they are not refined.
    void Run(const POVRect& of, bool counts, std::vector<Colour>& pixels)
    {
        block = of;
        pixels.clear();
        waiting.clear();
        refined.assign(block.GetArea(), false);
        for (int y = block.top; y <= int(block.bottom); y++)
            for (int x = block.left; x <= int(block.right); x++)
            {
                pixels.push_back(sampling.At(x, y));
                if (counts && sampling.First().contrast(x, y) >= options.rule.threshold)
                    Want(x, y);
            }
        for (std::size_t next = 0; next < waiting.size(); next++)
        {
            const int x = waiting[next].first, y = waiting[next].second;
            const bool busy = Refine(x, y, pixels[Index(x, y)]);
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
    bool Refine(int x, int y, Colour& colour)
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
                cooperate();
            }
        if (any)
            colour = trace.Integral().Refined();
        trace.Integral().End_Refinement();
        return refinement.scatter() >= options.rule.threshold;
    }

    ViewData& view;
    ViewThreadData& thread;
    TracePixel& trace;
    Trace::CooperateFunctor& cooperate;
    const IntegralRefinementOptions& options;
    IntegralSampling& sampling;
    ComparedEncoding compared;
    POVRect block;
    std::vector<bool> refined; ///< true also for pixels in `waiting`
    std::vector<std::pair<int, int>> waiting;
};

}

bool Refine_Integral_View(ViewData& view, ViewThreadData& thread, TracePixel& trace,
                          RadiosityFunction& radiosity, Trace::CooperateFunctor& cooperate,
                          const IntegralRefinementOptions& options)
{
    IntegralSampling *sampling = Sampling_Of(view.GetCamera());
    if (!sampling)
        return false;

    const pov_base::IntegralRows& rows = view.GetCamera().Integral_View->rows;
    const POVRect sampled = sampling->Needed(view.GetRenderArea());
    BlockRefinement refinement(view, thread, trace, cooperate, options, *sampling);
    POVRect block;
    unsigned int serial;
    std::vector<Colour> pixels;
    while (view.GetNextRectangle(block, serial))
    {
        radiosity.BeforeTile(options.reproducible ? serial : 0);
        // A block is refined as a whole, because a pixel can cause its neighbours to be refined. A
        // block that does not count is never marked final, so that +C may be used with other rows.
        const bool counts = rows.Meet(block.top, block.bottom);
        refinement.Run(block, counts, pixels);
        sampling->Done(block);
        radiosity.AfterTile();
        thread.AfterTile();
        const int before = int(std::min(block.bottom, sampled.bottom)) -
                           int(std::max(block.top, sampled.top)) + 1; // rows
        const float share = 1 - pass_share * std::max(0, before) / block.GetHeight();
        view.CompletedRectangle(block, serial, pixels, 1, options.final && counts, share);
        cooperate();
    }
    return true;
}

}
