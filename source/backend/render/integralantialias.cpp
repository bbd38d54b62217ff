// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/render/integralaudit.h"
#include "backend/render/integralcolours.h"
#include "backend/render/integralrefinement.h"
#include "backend/render/integralsamplers.h"
#include "backend/render/integralsampling.h"
#include "backend/render/integralstripes.h"
#include "backend/lighting/radiosity.h"
#include "backend/scene/camera.h"
#include "backend/scene/integralcamera.h"
#include "backend/scene/scene.h"
#include "backend/scene/view.h"

#include <algorithm>
#include <chrono>
#include <thread>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

namespace
{

IntegralSampling *Sampling_Of(const Camera& camera)
{
    return camera.Integral_View ? camera.Integral_View->sampling.get() : NULL;
}

/// The stripes that the view's anti-aliasing takes for pixels.
IntegralStripes Stripes_Of(const IntegralView& view)
{
    return IntegralStripes(view.sampled_optics == view.optics ? integral::Subpixels()
                                                              : view.optics->film.subpixels);
}

/// One thread's share of all passes. A block is one of the picture; its pixels, and those of its
/// stripes, are named alike.
class Antialiasing
{
public:
    Antialiasing(ViewData& view, ViewThreadData& thread, TracePixel& trace,
                 RadiosityFunction& radiosity, Trace::CooperateFunctor& cooperate,
                 const IntegralRefinementOptions& options, IntegralSampling& sampling)
        : view(view),
          thread(thread),
          trace(trace),
          radiosity(radiosity),
          cooperate(cooperate),
          options(options),
          sampling(sampling),
          stripes(Stripes_Of(*view.GetCamera().Integral_View)),
          compared(options.gamma),
          refinement(thread, trace.Integral(), cooperate, options, compared, sampling),
          first_samples(trace.Integral(), !options.jitter)
    {
        extra.rule = options.rule;
        extra.take = [&](int x, int y, int begin, int number, integral::LinearColour& sum)
        { return refinement.Take_Extra(x, y, begin, number, sum); };
    }

    void Run()
    {
        integral::PassSchedule& schedule = sampling.Schedule();
        while (const auto item = schedule.next())
        {
            while (!schedule.is_ready(*item))
            {
                cooperate(); // throws if the render is ended
                std::this_thread::sleep_for(std::chrono::microseconds(200));
            }
            Work(item->pass, item->block);
            schedule.finish(*item);
            sampling.Release();
            thread.AfterTile();
            cooperate();
        }
    }

private:
    void Work(int pass, const integral::PictureBlock& block)
    {
        // Without reconstruction, the last pass follows refinement directly.
        const bool is_last = pass == sampling.Last_Pass();
        if (pass == IntegralSampling::estimation && !is_last)
            return sampling.Reconstruction()->estimate(stripes.Of(block),
                                                       stripes.Of(sampling.Whole(block)), *scratch);
        radiosity.BeforeTile(options.reproducible ? block.top * view.GetWidth() + block.left : 0);
        if (is_last)
            Finish(block);
        else if (pass == IntegralSampling::reconstruction)
            Reconstruct(stripes.Of(block));
        else
            Trace_Pass(pass, block);
        radiosity.AfterTile();
    }

    /// The first or the second pass.
    void Trace_Pass(int pass, const integral::PictureBlock& block)
    {
        if (pass == IntegralSampling::sampling)
            Sample(stripes.Of(block));
        else
            refinement.Run(stripes.Of(block));
        const float share = pass == IntegralSampling::sampling ? IntegralSampling::sampling_share
                                                               : IntegralSampling::refinement_share;
        if (!sampling.Reports(block))
            return;
        if (!sampling.Is_Displayed())
            return view.CompletedRectangle(To_Rect(block), 0, share);
        Take(stripes.Of(block));
        stripes.Merge(pixels);
        view.CompletedRectangle(To_Rect(block), 0, pixels, 1, false, share);
    }

    /// Takes the first samples of a block.
    void Sample(const integral::PictureBlock& block)
    {
        for (int y = block.top; y <= block.bottom; y++)
            for (int x = block.left; x <= block.right; x++)
            {
                const IntegralPixel pixel = sampling.Lent() ? Sample_Beam(x, y)
                                                            : trace.Integral().Trace_Pixel(x, y, false);
                sampling.At(x, y) = pixel.colour;
                if (pixel.lens)
                    sampling.First().set(x, y, compared(pixel.colour), *pixel.lens, pixel.depth);
                thread.Stats()[Number_Of_Pixels] += x % stripes.Number() == 0;
                cooperate();
            }
    }

    /// Takes the first sample of a pixel's beam, and stores it for reconstruction.
    IntegralPixel Sample_Beam(int x, int y)
    {
        const auto pixel = first_samples.Trace(x, y);
        if (!pixel)
            return IntegralPixel::Without_Light();
        const auto& [hit, ray] = pixel->sample;
        sampling.Lent()->set_first(
            x, y, integral::light_field_ray(trace.Integral().View().Lattice(), pixel->centre),
            pixel->lens, trace.Integral().Seen(ray, hit));
        return {hit.light, pixel->lens, hit.depth};
    }

    /// Hands over a block as it is now, filtered if it has been reconstructed.
    void Finish(const integral::PictureBlock& block)
    {
        unsigned int serial;
        if (!sampling.Is_Wanted(block, serial))
            return;
        Take(stripes.Of(block));
        if (sampling.Filter())
            Filter(stripes.Of(block));
        stripes.Merge(pixels);
        if (IntegralAudit *const audit = view.GetCamera().Integral_View->audit.get())
            audit->Note(To_Rect(block), pixels, Squared_Errors(block));
        // A block outside the requested rows is rendered for its neighbours alone. It is never marked
        // final: a later +C that requests its rows must render it.
        view.CompletedRectangle(To_Rect(block), serial, pixels, 1,
                                options.final && Rows().Meet(block.top, block.bottom),
                                1 - sampling.Progress(block));
    }

    /// Reconstructs the light of a block.
    void Reconstruct(const integral::PictureBlock& block)
    {
        sampling.Reconstruction()->reconstruct(block, compared.Curve(), *scratch, reconstructed,
                                               &extra);
        std::size_t k = 0;
        for (int y = block.top; y <= block.bottom; y++)
            for (int x = block.left; x <= block.right; x++, k++)
            {
                Colour& colour = sampling.At(x, y);
                if (const auto& light = reconstructed[k])
                {
                    for (int channel = 0; channel < 3; channel++)
                        colour[channel] = (*light)[channel];
                    colour.transm() = (*light)[3];
                }
                sampling.First().recolour(x, y, compared(colour));
            }
    }

    /// Lowers the noise in `pixels`, the reconstructed light of a block.
    void Filter(const integral::PictureBlock& block)
    {
        const auto noise = [&](int x, int y)
        { return sampling.Reconstruction()->noise_left(x, y); };
        sampling.Filter()->filter(block, noise, *filter_scratch, changes);
        std::size_t k = 0;
        for (int y = block.top; y <= block.bottom; y++)
            for (int x = block.left; x <= block.right; x++, k++)
                if (Rows().Have(y))
                {
                    for (int channel = 0; channel < 3; channel++)
                        pixels[k][channel] = compared.Changed(pixels[k][channel],
                                                              changes[k][channel]);
                    if (changes[k][3] != 0)
                        pixels[k].transm() = std::clamp(pixels[k].transm() + changes[k][3], 0.0f,
                                                        1.0f);
                }
    }

    /// The expected squared errors of a block's pixels, for IntegralAudit::Note.
    const std::vector<float>& Squared_Errors(const integral::PictureBlock& block)
    {
        squared_errors.clear();
        for (int y = block.top; y <= block.bottom; y++)
            for (int x = block.left; x <= block.right; x++)
                squared_errors.push_back(Squared_Error(x, y));
        return squared_errors;
    }

    /// The expected squared error of a pixel: the mean of its stripes'.
    float Squared_Error(int x, int y)
    {
        const int number = stripes.Number();
        float sum = 0;
        bool is_lit = false;
        for (int stripe = x * number; stripe < (x + 1) * number; stripe++)
            if (sampling.First().lens(stripe, y))
            {
                is_lit = true;
                if (!sampling.Reconstruction())
                    return IntegralAudit::unknown;
                sum += sampling.Reconstruction()->error_left(stripe, y);
            }
        return is_lit ? sum / number : IntegralAudit::unlit;
    }

    /// Sets `pixels` to the block's colours.
    void Take(const integral::PictureBlock& block)
    {
        pixels.clear();
        for (int y = block.top; y <= block.bottom; y++)
            for (int x = block.left; x <= block.right; x++)
                pixels.push_back(sampling.At(x, y));
    }

    /// The rows that count (Integral_Rows=).
    const pov_base::IntegralRows& Rows() const { return view.GetCamera().Integral_View->rows; }

    static POVRect To_Rect(const integral::PictureBlock& block)
    {
        return POVRect(block.left, block.top, block.right, block.bottom);
    }

    ViewData& view;
    ViewThreadData& thread;
    TracePixel& trace;
    RadiosityFunction& radiosity;
    Trace::CooperateFunctor& cooperate;
    const IntegralRefinementOptions& options;
    IntegralSampling& sampling;
    const IntegralStripes stripes;
    ComparedEncoding compared;
    IntegralRefinement refinement;
    IntegralFirstSamples first_samples;
    std::vector<Colour> pixels;
    std::vector<float> squared_errors;
    integral::Reconstruction::ExtraSamples extra;
    integral::Reconstruction::ScratchPointer scratch = integral::Reconstruction::make_scratch();
    std::vector<integral::Reconstruction::Result> reconstructed;
    integral::NoiseFilter::ScratchPointer filter_scratch = integral::NoiseFilter::make_scratch();
    std::vector<integral::FourFloats> changes;
};

}

bool Antialias_Integral_View(ViewData& view, ViewThreadData& thread, TracePixel& trace,
                             RadiosityFunction& radiosity, Trace::CooperateFunctor& cooperate,
                             const IntegralRefinementOptions& options)
{
    IntegralSampling *const sampling = Sampling_Of(view.GetCamera());
    if (!sampling)
        return false;
    sampling->Begin(view);
    radiosity.integralAmbient = trace.Integral().Ambient();
    Antialiasing(view, thread, trace, radiosity, cooperate, options, *sampling).Run();
    return true;
}

}
