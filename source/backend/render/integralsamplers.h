// SPDX-License-Identifier: AGPL-3.0-or-later
// Chooses the camera rays of anti-aliasing and of the audit, and traces them: the first samples of
// pixels of a row, further samples of one pixel's beam, and independent reference samples.
#ifndef POVRAY_BACKEND_INTEGRALSAMPLERS_H
#define POVRAY_BACKEND_INTEGRALSAMPLERS_H

#include <cstdint>
#include <optional>
#include <vector>

#include "backend/frame.h"
#include "backend/render/integraltracer.h"
#include "integral/reconstruction/light_field_image.h"

namespace pov
{

/// A traced sample of a pixel's beam.
struct IntegralSample
{
    IntegralHit hit; ///< on a film of subpixels, the light of all channels, and the surface that the last
                     ///< channel's ray met
    integral::BeamRay ray; ///< the last ray
};

/// The first samples of the pixels of a row, for cameras with one ray per pixel. Works out the rays
/// of integral::run_length pixels at once.
class IntegralFirstSamples
{
public:
    struct Pixel
    {
        integral::LensIndex lens;
        integral::BeamRay centre; ///< from the pixel's centre through the lens's pole
        IntegralSample sample;
    };

    /// `same_pattern`: use the same sample pattern in every pixel.
    IntegralFirstSamples(IntegralTracer& tracer, bool same_pattern)
        : tracer(tracer), same_pattern(same_pattern)
    {
    }

    /// Traces pixel (x, y), counted from 0; nothing if it images nothing. Quick if the last call was
    /// about the pixel to the left.
    std::optional<Pixel> Trace(int x, int y);

private:
    std::optional<Pixel> Trace_Of_View(int x, int y);

    IntegralTracer& tracer;
    const bool same_pattern;
    int run_x = 0, run_y = -1; ///< the first pixel of the run; initially none
    integral::PixelRun run;
    integral::RayRun<integral::BeamRay> samples;
};

/// Further samples of the beam of one pixel.
class IntegralBeam
{
public:
    explicit IntegralBeam(IntegralTracer& tracer) : tracer(tracer) {}

    /// Begins with pixel (x, y). `image`: what the first samples of this pixel and of those around
    /// showed.
    void Begin(int x, int y, bool same_pattern, const integral::LightFieldImage& image);

    /// Traces sample `index`. It is the first of `number` (at least 1) samples that are to be traced one
    /// after the other; their rays are computed together. Nothing if another lens images it.
    std::optional<IntegralSample> Trace(std::uint32_t index, int number);

    /// Adds a sample's light that is known already.
    void Add(const Colour& light_of_sample) { light.Add(integral::PixelRay(), light_of_sample); }

    /// The mean light of the samples since Begin.
    Colour Mean() const { return light.Mean(2); }

private:
    void Append_Rays(std::uint32_t index, int number);

    IntegralTracer& tracer;
    int x = 0, y = 0;
    bool of_same_pattern = false; ///< of a quilt's pixel
    integral::PixelBeam beam;
    IntegralLight light;
    std::uint32_t run_begin = 0, run_end = 0; ///< the samples whose rays are in `run`
    integral::RayRun<std::optional<integral::BeamRay>> run;
    std::vector<integral::PixelRay> rays; ///< of one sample
};

/// The light of pixel (x, y) along one random ray for each channel, number `index` of a `set`
/// (PixelSampler::append_reference_ray). Transparent if no light gets through. `rays` is scratch.
Colour Trace_Integral_Reference(IntegralTracer& tracer, int x, int y, std::uint64_t set,
                                std::uint32_t index, std::vector<integral::PixelRay>& rays);

}

#endif
