// SPDX-License-Identifier: AGPL-3.0-or-later
// One thread's share of an integral camera: makes the camera rays of its pixels, adds up their
// light and counts them.
#ifndef POVRAY_BACKEND_INTEGRALTRACER_H
#define POVRAY_BACKEND_INTEGRALTRACER_H

#include <cstdint>
#include <memory>
#include <vector>

#include "backend/frame.h"
#include "backend/render/integralcontainers.h"
#include "backend/render/integralshading.h"
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
    /// Takes on a camera; one that is not integral leaves Active() false.
    void Setup(const Camera& camera, SceneData& scene, TraceThreadData *thread);

    bool Active() const { return active; }

    /// Whether POV-Ray is to look for the objects that a ray starts inside of.
    bool Search_Containers() const { return containers.Left_To_POV(); }

    /// Where the thread's rays share their shading; nothing if they do not.
    IntegralCachedShading *Shading() { return shading.get(); }

    /// From here on, each pixel is given by one random ray, number `index` of it, and is not
    /// counted.
    void Audit(std::uint64_t index)
    {
        mode = audit;
        audit_index = index;
    }

    /// From here on, pixel (x, y), counted from 0, is given by single samples of its beam, to be
    /// chosen by Take. `alike`: chosen alike in every pixel. `depth`: of what the pixel shows, as
    /// Depth tells it.
    void Refine(int x, int y, bool alike, double depth);
    void Take(std::uint32_t index) { sample_index = index; }

    /// The mean of the samples that have been taken since Refine.
    Colour Refined() const { return refined.Mean(2); }

    /// Each pixel is given by the camera's own rays again.
    void End_Refinement() { mode = camera_rays; }

    /// Whether the last pixel, or sample, imaged anything; and the lens that did.
    bool Imaged() const { return imaged; }
    integral::LensIndex Lens() const { return lens; }

    /// Of what the last ray of the last pixel met, mm from the sheet away from the viewer; infinite
    /// if nothing. Only with +A.
    double Depth() const { return last_depth; }

    /// The colour of pixel (x, y), counted from 0. `trace(Ray&, DBL length, Colour&)` traces one
    /// ray as far as the camera sees along it (scene units; 0 = without end), and tells how far
    /// away what it met is (HUGE_VAL: nothing). A pixel that images nothing is clear.
    template <class Trace>
    void Trace_Pixel(DBL x, DBL y, bool pretrace, Colour& colour, Trace trace);

private:
    enum Mode
    {
        camera_rays,
        audit,
        refinement
    };

    /// The light of a pixel's rays, mean by mean: of both halves of the samples, and of each colour
    /// channel.
    struct Light
    {
        Colour sums[2][3]; ///< [half][channel]: only red, green or blue of each counts, and a third
                           ///< of the others
        DBL weights[2][3] = {};
        int rays[2] = {};
        void Add(const integral::PixelRay& ray, const Colour& seen);
        /// Mean of one half, or of both (half 2).
        Colour Mean(int half) const;
    };

    bool Choose_Rays(DBL x, DBL y, bool counted);
    bool Choose_One_Ray(DBL x, DBL y, bool counted, bool pretrace, Ray& ray, DBL& length);
    void Count(const integral::PixelOutcome& outcome, std::size_t traced) const;
    int Place_In_Run(DBL x, DBL y);
    void Make_Ray(Ray& ray, const integral::BeamRay& beam, bool pretrace, DBL& length) const;
    void Make_Ray(Ray& ray, const integral::SightLine& line, bool pretrace, DBL& length) const;
    void Count_Error(DBL y, const Light& light);
    void Met(const Ray& ray, DBL distance)
    {
        if (keeps_depth && mode == camera_rays)
            Keep_Depth(ray, distance);
    }
    void Keep_Depth(const Ray& ray, DBL distance);

    std::shared_ptr<const IntegralView> view;
    IntegralContainers containers;
    std::unique_ptr<IntegralCachedShading> shading;
    TraceThreadData *thread = nullptr;
    IntegralTally *tally = nullptr;       ///< in the view's counts, if it keeps any
    std::vector<integral::PixelRay> rays; ///< of the pixel, or sample, that is being traced
    integral::LensIndex lens;             ///< whose rays they are
    bool imaged = false;                  ///< whether there are any
    Mode mode = camera_rays;
    std::uint64_t audit_index = 0;
    integral::PixelBeam beam; ///< of the pixel that is being refined
    Light refined;            ///< of its samples
    std::uint32_t sample_index = 0;
    bool active = false, counts_error = false;
    bool keeps_depth = false; ///< of what rays meet
    double last_depth = 0;
    bool one_ray = false;        ///< whether each pixel has one ray at most
    integral::PixelRun run;      ///< such pixels, mapped side by side
    DBL run_x = 0, run_y = -1;   ///< the first of them; y < 0: none as yet
    DBL last_x = 0, last_y = -1; ///< the last pixel that was asked for
};

template <class Trace>
void IntegralTracer::Trace_Pixel(DBL x, DBL y, bool pretrace, Colour& colour, Trace trace)
{
    const bool counted = !pretrace && mode != audit && tally;
    colour.clear();
    DBL length;
    if (mode == camera_rays && one_ray)
    {
        Ray ray;
        if (Choose_One_Ray(x, y, counted, pretrace, ray, length))
            Met(ray, trace(ray, length, colour));
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
        Make_Ray(ray, rays[0].ray, pretrace, length);
        Met(ray, trace(ray, length, colour));
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
        Met(ray, trace(ray, length, seen));
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
