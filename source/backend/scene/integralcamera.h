// SPDX-License-Identifier: AGPL-3.0-or-later
// The integral camera as a scene carries it: what its statement says, and the view that is rendered
// by it. Camera holds a pointer to each; one without is POV-Ray's own.
#ifndef POVRAY_BACKEND_INTEGRALCAMERA_H
#define POVRAY_BACKEND_INTEGRALCAMERA_H

#include <atomic>
#include <list>
#include <memory>
#include <mutex>
#include <set>
#include <string>

#include "backend/frame.h"
#include "base/integraloptions.h"
#include "integral/lightfield/error_estimate.h"
#include "integral/lightfield/pixel_sampler.h"
#include "integral/optics/camera.h"

class POVMS_Object;

namespace pov
{

class Camera;
class IntegralAudit;
class IntegralDepth;
class IntegralShadingCache;
class IntegralSampling;
class RenderTask;
class SceneData;
class ViewData;

inline integral::Vec3 From_POV(const VECTOR v) { return {v[X], v[Y], v[Z]}; }

/// A count that one thread adds to and others may read: no locked instruction is needed.
class OwnCount
{
public:
    void Add(long long amount) { count.store(Get() + amount, std::memory_order_relaxed); }
    long long Get() const { return count.load(std::memory_order_relaxed); }

private:
    std::atomic<long long> count{0};
};

/// Counts of one thread of a render, which alone writes them. All are of camera rays of the
/// picture itself; radiosity's pretrace and the audit are left out.
struct IntegralTally
{
    OwnCount film_points, imaged, searched, outside_aperture, total_reflection;
    OwnCount rays;               ///< traced
    OwnCount container_searches; ///< of these, those whose containers had to be looked for
    OwnCount shared_shadings, patch_shadings; ///< surfaces that took a shared colour; of these,
                                              ///< those for which it was worked out
    integral::ErrorSums errors; ///< of the pixels whose halves were compared; to be read once the
                                ///< thread is done
};

/// The tallies of a render's threads.
struct IntegralCounts
{
    std::mutex mutex;
    std::list<IntegralTally> tallies; ///< list: a thread keeps a reference to its own
    int containers = 0;               ///< objects that rays may start inside of
    int objects = 0;                  ///< of these many in the scene
};

/// What a render's options say of the error estimate.
struct IntegralErrorOptions
{
    bool wanted = true;
    double share = 0; ///< of the lit pixels to audit; 0: 0.5% (5% for a picture), and at least 1000
    integral::OutputCurve output;
    std::string picture; ///< file of the error picture; empty: none
};

/// What a camera statement, or Integral_Camera=, says. It does not change once it is parsed; copies
/// of a camera share it.
struct IntegralStatement
{
    bool integral = false; ///< false: only notes for Integral_Camera= to use
    integral::CameraParameters parameters;
    std::set<std::string> given;     ///< the words that have been given, to refuse a second
    double look_at_distance = 0;     ///< |look_at - location|, scene units; 0: no look_at
    double sheet_distance_ratio = 0; ///< sheet distance / |direction|; 0: not known yet
    std::shared_ptr<const integral::IntegralCamera> optics; ///< by the camera's last transform;
                                                            ///< nothing: no frame size yet
};

/// A view that is being rendered: its optics, and what its threads share.
struct IntegralView
{
    std::shared_ptr<const integral::IntegralCamera> optics;
    std::shared_ptr<const integral::PixelSampler> sampler;
    std::shared_ptr<IntegralCounts> counts;
    std::shared_ptr<IntegralShadingCache> shading_cache; ///< nothing: each ray's shading is its own
    bool caches_dear_shading_only = false;               ///< if there is a cache
    std::shared_ptr<IntegralSampling> sampling;          ///< nothing: no anti-aliasing
    std::shared_ptr<IntegralAudit> audit;                ///< nothing: no audit estimates the error
    std::shared_ptr<IntegralDepth> depth;                ///< nothing: no depth frame
    IntegralErrorOptions error;
    pov_base::IntegralRows rows; ///< the rows that count
};

/// The statement's optics for a frame of width x height pixels, from the vectors of `camera`.
/// Throws std::invalid_argument with a sentence for the user.
std::shared_ptr<const integral::IntegralCamera> Make_Integral_Optics(const Camera& camera,
                                                                     int width, int height);

/// To be called once a scene is parsed: chooses how its objects are bounded, where the options
/// leave that open. A tree of the scene's space (+BM2) is left sooner than boxes in boxes by rays
/// that start apart and go apart, as an integral camera's do; but it takes longer to build, and
/// that has to pay. Other cameras get POV-Ray's own way.
void Choose_Integral_Bounding(SceneData& scene);

/// To be called once a view's camera and size are settled: gives it optics and a sampler of its own
/// and fresh counts, and announces its geometry to whoever writes the picture. No effect on other
/// cameras.
void Start_Integral_View(Camera& camera, int width, int height, POVMS_Object& options);

/// The tasks that a view is to run once it is rendered, `threads` of each kind: the depth frame and
/// the audit.
int Integral_Final_Tasks(const Camera& camera, int threads);
RenderTask *New_Integral_Final_Task(ViewData *view, int index); ///< index from 0

/// Adds the counts and the error to a view's statistics message, once it is rendered. No effect on
/// other cameras.
void Get_Integral_Statistics(const Camera& camera, POVMS_Object& statistics);

}

#endif
