// SPDX-License-Identifier: AGPL-3.0-or-later
// Traces pixels of an integral camera in one thread: makes their camera rays, averages the rays'
// light and counts them.
#ifndef POVRAY_BACKEND_INTEGRALTRACER_H
#define POVRAY_BACKEND_INTEGRALTRACER_H

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "backend/frame.h"
#include "backend/render/integralarealights.h"
#include "backend/render/integralcolours.h"
#include "backend/render/integralcontainers.h"
#include "backend/render/integralshading.h"
#include "backend/lighting/integralsharedambient.h"
#include "integral/lightfield/beam_samples.h"
#include "integral/lightfield/pixel_sampler.h"
#include "integral/optics/pixel_run.h"

namespace pov
{

class Camera;
class Ray;
class SceneData;
class TraceThreadData;
struct IntegralView;
struct IntegralTally;

class IntegralTracer
{
public:
    /// Prepares for a camera. Active() becomes true if the camera is integral.
    /// `normal`: where the surface's normal is found after a ray has been traced.
    void Setup(const Camera& camera, SceneData& scene, TraceThreadData *thread, const DBL *normal);

    bool Active() const { return active; }

    /// Whether POV-Ray's own search must find the objects inside which a ray starts.
    bool Search_Containers() const { return containers.Left_To_POV(); }

    /// The shared shading of the thread's rays; null if they do not share.
    IntegralCachedShading *Shading() { return shading.get(); }

    /// The choice of the area lights' parts that samples see; null if they see all of them.
    IntegralAreaLights *Area_Lights() { return area_lights.get(); }

    /// Radiosity's ambient light that rays share; null: each ray looks up its own.
    IntegralAmbient *Ambient() { return ambient.get(); }

    /// From now on Trace_Pixel traces one random ray per pixel, number `index` of a `set`
    /// (PixelSampler::append_random_ray), and does not count it.
    void Audit(std::uint64_t set, std::uint32_t index)
    {
        mode = audit;
        audit_set = set;
        audit_index = index;
    }

    /// From now on Trace_Pixel traces the first sample of each pixel's beam. For cameras with one
    /// ray per pixel. `alike`: use the same sample pattern in every pixel.
    void Take_First_Samples(bool alike)
    {
        mode = first_samples;
        alike_samples = alike;
    }

    /// From now on Trace_Pixel traces single samples of the beam of pixel (x, y), counted from 0;
    /// Take chooses which. `samples`: what the first samples of this pixel and of those around
    /// showed. `first`: the colour of the first sample if it counts; else null.
    void Refine(int x, int y, bool alike, const integral::FirstSamples& samples,
                const Colour *first);
    /// `number`, at least 1: of samples that are to be taken one after the other, this one being
    /// the first. Their rays are worked out together.
    void Take(std::uint32_t index, int number)
    {
        sample_index = index;
        samples_wanted = number;
    }

    /// The mean of the samples that were traced since Refine.
    Colour Refined() const { return refined.Mean(2); }

    /// From now on Trace_Pixel traces the camera's own rays again.
    void Take_Camera_Rays() { mode = camera_rays; }

    /// Of the last of the pixels' first samples: the ray from its pixel's centre through the lens's
    /// pole.
    const integral::BeamRay& Centre() const { return centre; }

    /// Whether the last pixel, or sample, imaged anything; and the lens that did.
    bool Imaged() const { return imaged; }
    integral::LensIndex Lens() const { return lens; }

    /// The depth at which the viewer sees the surface that the last ray of the last pixel met, mm
    /// from the sheet away from the viewer; infinite if it met none. Only with +A.
    double Depth() const { return last_depth; }

    /// What the last ray of the last sample saw; `colour`: its light. Only if the frame
    /// is reconstructed.
    integral::BeamSamples::Seen Seen(const Colour& colour) const;

    /// Computes the colour of pixel (x, y), counted from 0. `trace(Ray&, DBL length, Colour&)`
    /// traces one ray up to the distance `length` (scene units; 0 = unlimited) and returns the
    /// distance of the surface that it met (HUGE_VAL: none). A pixel that images nothing becomes
    /// transparent.
    template <class Trace>
    void Trace_Pixel(DBL x, DBL y, bool pretrace, Colour& colour, Trace trace);

private:
    enum Mode
    {
        camera_rays,
        audit,
        first_samples,
        refinement
    };

    /// Sums of the light of a pixel's rays, separately for both halves of the samples and for each
    /// colour channel.
    struct Light
    {
        static constexpr int all = 3; ///< stands for all channels
        Colour sums[2][4]; ///< [half][channel]: only the channel's own colour is used, and a third
                           ///< of the other components
        DBL weights[2][4] = {};
        int rays[2] = {};
        void Add(const integral::PixelRay& ray, const Colour& seen);
        /// The mean of one half (0 or 1), or of both halves (2).
        Colour Mean(int half) const;
    };

    void Choose_Area_Lights(DBL x, DBL y);
    bool Choose_Rays(DBL x, DBL y, bool counted);
    void Append_Sample();
    bool Choose_First_Sample(DBL x, DBL y, bool counted, bool pretrace, Ray& ray, DBL& length);
    bool Choose_Quilt_Ray(DBL x, DBL y, bool counted, bool pretrace, Ray& ray, DBL& length);
    bool Choose_One_Ray(DBL x, DBL y, bool counted, bool pretrace, Ray& ray, DBL& length);
    void Count(const integral::PixelOutcome& outcome, std::size_t traced) const;
    int Place_In_Run(DBL x, DBL y);
    void Make_Ray(Ray& ray, const integral::BeamRay& beam, bool pretrace, DBL& length) const;
    void Make_Ray(Ray& ray, const integral::SightLine& line, bool pretrace, DBL& length) const;
    void Count_Error(DBL y, const Light& light);
    void Met(const Ray& ray, DBL distance)
    {
        if (keeps_depth && mode != audit)
            Keep_Depth(ray, distance);
    }
    void Keep_Depth(const Ray& ray, DBL distance);
    std::array<float, 2> Tilt(const integral::SightSlope& line) const;

    std::shared_ptr<const IntegralView> view;
    IntegralContainers containers;
    std::unique_ptr<IntegralCachedShading> shading;
    std::unique_ptr<IntegralAreaLights> area_lights;
    std::unique_ptr<IntegralSharedAmbient> ambient;
    TraceThreadData *thread = nullptr;
    IntegralTally *tally = nullptr;       ///< this thread's counts; null if the view has none
    std::vector<integral::PixelRay> rays; ///< of the pixel or sample that is being traced
    integral::LensIndex lens;             ///< the lens of these rays
    bool imaged = false;                  ///< whether there are such rays
    Mode mode = camera_rays;
    std::uint64_t audit_set = 0;
    std::uint32_t audit_index = 0;
    bool alike_samples = false;
    integral::BeamRay sampled, centre; ///< of the last sample
    integral::PixelBeam beam;          ///< of the pixel that is being refined
    Light refined;                     ///< of its samples
    std::uint32_t sample_index = 0;
    int samples_wanted = 0;
    integral::RayRun<std::optional<integral::BeamRay>> refined_run; ///< rays of samples of `beam`
    std::uint32_t refined_begin = 0, refined_end = 0;               ///< the samples' indices
    bool active = false, counts_error = false;
    pov_base::IntegralClipping clipping = pov_base::IntegralClipping::colours;
    bool keeps_depth = false; ///< whether Depth is available
    double last_depth = 0;
    integral::Vec3 last_point; ///< of the scene, where last_depth is finite
    const DBL *normal = nullptr; ///< of the surface that the last ray met
    bool one_ray = false;        ///< whether each pixel has at most one ray
    bool quilt = false;          ///< whether the picture is a quilt of views; then one_ray is true
    integral::PixelRun run;      ///< pixels of a row mapped at once: the last run that was computed
    DBL run_x = 0, run_y = -1;   ///< its first pixel; initially none
    integral::RayRun<integral::BeamRay> run_samples; ///< the first samples of such a run
    DBL first_x = 0, first_y = -1;                     ///< its first pixel; initially none
    DBL last_x = 0, last_y = -1; ///< the last pixel that was traced
};

template <class Trace>
void IntegralTracer::Trace_Pixel(DBL x, DBL y, bool pretrace, Colour& colour, Trace trace)
{
    const bool counted = !pretrace && mode != audit && tally;
    if (area_lights)
        Choose_Area_Lights(x, y);
    colour.clear();
    DBL length;
    const auto see = [&](Ray& ray, Colour& seen)
    {
        Met(ray, trace(ray, length, seen));
        Clip(clipping, seen);
    };
    if ((mode == camera_rays && one_ray) || mode == first_samples)
    {
        Ray ray;
        if (mode == first_samples ? Choose_First_Sample(x, y, counted, pretrace, ray, length)
            : quilt               ? Choose_Quilt_Ray(x, y, counted, pretrace, ray, length)
                                  : Choose_One_Ray(x, y, counted, pretrace, ray, length))
            see(ray, colour);
        else
            colour.transm() = 1.0;
        return;
    }
    if (!Choose_Rays(x, y, counted))
    {
        colour.transm() = 1.0;
        return;
    }
    if (rays.size() == 1 && rays[0].channel == integral::PixelRay::all_channels)
    {
        Ray ray;
        sampled = rays[0].ray;
        Make_Ray(ray, sampled, pretrace, length);
        see(ray, colour);
        if (mode == refinement)
            refined.Add(rays[0], colour);
        return;
    }
    Light light;
    for (const integral::PixelRay& pixel_ray : rays)
    {
        Ray ray;
        Colour seen;
        Make_Ray(ray, pixel_ray.ray, pretrace, length);
        see(ray, seen);
        light.Add(pixel_ray, seen);
        if (mode == refinement)
            refined.Add(pixel_ray, seen);
    }
    colour = light.Mean(2);
    if (counted && counts_error)
        Count_Error(y, light);
}

}

#endif
