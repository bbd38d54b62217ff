// SPDX-License-Identifier: AGPL-3.0-or-later
// Traces camera rays of an integral camera in one thread, and counts them. Code that chooses rays
// (integralsamplers.h) or uses hits (integralantialias.cpp, integralrefinement.cpp, integralaudit.cpp) keeps
// its own state.
#ifndef POVRAY_BACKEND_INTEGRALTRACER_H
#define POVRAY_BACKEND_INTEGRALTRACER_H

#include <cmath>
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
#include "integral/optics/pixel_run.h"
#include "integral/reconstruction/beam_samples.h"
#include "integral/sampling/pixel_sampler.h"

namespace pov
{

class Camera;
class Ray;
class SceneData;
class TracePixel;
class TraceThreadData;
struct IntegralView;
struct ThreadCounters;

/// The light along a camera ray, and the surface that the ray met.
struct IntegralHit
{
    Colour light;            ///< clipped to what the picture's file can hold
    double depth = HUGE_VAL; ///< where the viewer sees the surface, mm from the sheet away from the
                             ///< viewer; infinite: none was met, or the view has no +A
    integral::Vec3 point, normal; ///< of the surface, in the scene; valid if `depth` is finite
};

/// A pixel that is traced by the camera's own rays.
struct IntegralPixel
{
    Colour colour;                           ///< transparent if the pixel images nothing
    std::optional<integral::LensIndex> lens; ///< the lens of its rays; nothing if there are none
    double depth = HUGE_VAL;                 ///< IntegralHit::depth of the last ray

    static IntegralPixel Without_Light()
    {
        IntegralPixel pixel;
        pixel.colour.clear();
        pixel.colour.transm() = 1.0;
        return pixel;
    }
};

/// Sums of the light of several rays, separately for both halves of the samples and for each colour
/// channel.
class IntegralLight
{
public:
    void Add(const integral::PixelRay& ray, const Colour& seen);
    void Add(const IntegralLight& other);
    /// The mean of one half (0 or 1), or of both halves (2).
    Colour Mean(int half) const;
    /// The number of rays in a half.
    int Rays(int half) const { return rays[half]; }

private:
    static constexpr int all = 3; ///< stands for all channels
    Colour sums[2][4]; ///< [half][channel]: the mean uses the channel's own colour, and a third of filter and
                       ///< transmittance
    DBL weights[2][4] = {};
    int rays[2] = {};
};

class IntegralTracer
{
public:
    /// Prepares for a camera. Active() becomes true if the camera is integral. `pixels` traces the rays and
    /// must outlive this. `normal`: the variable that holds the surface's normal after a ray has been traced.
    void Setup(const Camera& camera, SceneData& scene, TraceThreadData *thread, TracePixel& pixels,
               const DBL *normal);

    bool Active() const { return view != nullptr; }
    const IntegralView& View() const { return *view; }

    /// Whether POV-Ray's own search must find the objects inside which a ray starts.
    bool Search_Containers() const { return containers.Use_Generic_Search(); }

    /// The shared shading of the thread's rays; null if they do not share.
    IntegralCachedShading *Shading() { return shading.get(); }

    /// The choice of the area lights' parts that samples see; null if they see all of them.
    IntegralAreaLights *Area_Lights() { return area_lights.get(); }

    /// Radiosity's ambient light that rays share; null: each ray looks up its own.
    IntegralAmbient *Ambient() { return ambient.get(); }

    /// Traces pixel (x, y), counted from 0, by the camera's own rays.
    IntegralPixel Trace_Pixel(DBL x, DBL y, bool pretrace);

    /// Traces one ray.
    IntegralHit Trace(const integral::SightLine& line, bool pretrace = false);
    IntegralHit Trace(const integral::BeamRay& ray, bool pretrace = false);
    /// Traces the rays, at least one, of one pixel or sample, and adds their light to `light`,
    /// which is empty. Returns their mean light, and the surface that the last of them met.
    IntegralHit Trace(const std::vector<integral::PixelRay>& rays, IntegralLight& light,
                      bool pretrace = false);

    /// The record of a ray and its hit for reconstruction.
    integral::BeamSamples::Seen Seen(const integral::BeamRay& ray, const IntegralHit& hit) const;

    /// Begins sample `index` of pixel (x, y): chooses the parts of area lights that it sees.
    void Begin_Sample(DBL x, DBL y, std::uint32_t index);
    /// The same for an independent sample of a `set`.
    void Begin_Reference(DBL x, DBL y, std::uint64_t set, std::uint32_t index);

    /// Adds a pixel, for which `traced` rays were traced, to the view's statistics.
    void Count(const integral::PixelOutcome& outcome, std::size_t traced) const;

private:
    /// Pole rays of pixels that POV-Ray's loops request one by one. If successive pixels are neighbours in a
    /// row, the rays of a run of pixels are computed at once.
    class Row_Walk
    {
    public:
        /// The index of pixel (x, y) in Run(), or -1.
        int Place(const integral::IntegralCamera& camera, DBL x, DBL y);
        const integral::PixelRun& Run() const { return run; }

    private:
        integral::PixelRun run;
        DBL run_x = 0, run_y = -1;   ///< the run's first pixel; initially none
        DBL last_x = 0, last_y = -1; ///< the pixel of the last call
    };

    IntegralPixel Trace_One_Ray(DBL x, DBL y, bool pretrace);
    IntegralPixel Trace_Quilt_Pixel(DBL x, DBL y, bool pretrace);
    IntegralPixel Trace_Samples(DBL x, DBL y, bool pretrace);
    void Count_Error(DBL y, const IntegralLight& light);
    std::array<float, 2> Tilt(const integral::LightFieldRay& line, const IntegralHit& hit) const;

    std::shared_ptr<const IntegralView> view;
    TracePixel *pixels = nullptr;
    const DBL *normal = nullptr; ///< of the surface that the last ray met
    EnclosingObjects containers;
    std::unique_ptr<IntegralCachedShading> shading;
    std::unique_ptr<IntegralAreaLights> area_lights;
    std::unique_ptr<IntegralSharedAmbient> ambient;
    TraceThreadData *thread = nullptr;
    ThreadCounters *counters = nullptr;   ///< this thread's
    bool finds_depth = false;             ///< whether hits have a depth
    Row_Walk walk;                        ///< for cameras with one ray per pixel
    std::vector<integral::PixelRay> rays; ///< scratch of Trace_Samples
};

}

#endif
