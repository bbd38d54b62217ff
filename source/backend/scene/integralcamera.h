// SPDX-License-Identifier: AGPL-3.0-or-later
// The integral camera's part of class Camera: the settings of its statement, and the view that is
// being rendered. Camera holds a pointer to each; they are null for POV-Ray's own cameras.
#ifndef POVRAY_BACKEND_INTEGRALCAMERA_H
#define POVRAY_BACKEND_INTEGRALCAMERA_H

#include <atomic>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "backend/frame.h"
#include "base/integralclipping.h"
#include "base/integraloptions.h"
#include "integral/frame/error_estimate.h"
#include "integral/optics/camera.h"
#include "integral/sampling/pixel_sampler.h"
#include "integral/sampling/quilt_sampler.h"

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

/// A count that one thread increases and others may read, without locked instructions.
class SingleWriterCounter
{
public:
    void Add(long long amount) { count.store(Get() + amount, std::memory_order_relaxed); }
    long long Get() const { return count.load(std::memory_order_relaxed); }

private:
    std::atomic<long long> count{0};
};

/// The counts of one render thread, which is the only one to write them. Rays of radiosity's
/// pretrace and of the audit are not counted.
struct ThreadCounters
{
    SingleWriterCounter film_points, imaged, searched, outside_aperture, total_reflection;
    SingleWriterCounter rays;               ///< rays traced
    SingleWriterCounter container_searches; ///< rays for which objects around their start were searched
    SingleWriterCounter shared_shadings, patch_shadings; ///< ray hits that used a shared colour, or shared
                                              ///< ambient light; how many of them had to compute
                                              ///< it
    integral::ErrorSums errors; ///< errors of pixels from their two halves of samples; read only
                                ///< after the thread has ended
};

/// The range of the colours of finished pixels.
struct IntegralColours
{
    long long pixels = 0; ///< number of finished pixels
    float least[3] = {HUGE_VALF, HUGE_VALF, HUGE_VALF};
    float most[3] = {-HUGE_VALF, -HUGE_VALF, -HUGE_VALF};

    /// Adds pixels. Transparent black ones, behind no lens, have no colour.
    void Add(const std::vector<Colour>& colours);

    /// Whether `all` pixels are finished and their colours differ by less than a step of 8 bits.
    bool Are_One(double all, const integral::OutputCurve& output) const;
};

/// The counters of a render's threads.
struct IntegralCounts
{
    std::mutex mutex;
    std::list<ThreadCounters> tallies; ///< a list, since each thread keeps a reference to its own
    int containers = 0;               ///< number of objects inside which rays may start
    int objects = 0;                  ///< number of objects in the scene
    IntegralColours colours;
};

/// The options of the error estimate.
struct IntegralErrorOptions
{
    bool by_halves = false; ///< estimate it from the two halves of all pixels' samples
    bool radiosity = false; ///< whether the noise of radiosity's points is part of it
    double share = 0; ///< fraction of the lit pixels to audit; 0: the default, by the frame's rays
                      ///< (integralaudit.cpp); 0.05 with an error picture
    integral::OutputCurve output;
    std::string picture;    ///< file of the error picture; empty: none
    bool continued = false; ///< some pixels come from an earlier run (+C); their errors are unknown
};

/// The settings of a camera statement or of Integral_Camera=. They do not change after parsing, and
/// copies of a camera share them.
struct IntegralStatement
{
    bool integral = false; ///< false: another camera, whose values apply if Integral_Camera= makes it
                           ///< integral
    integral::CameraParameters parameters;
    /// The sheet's pitch as seen from viewing_distance, mm; nothing: parameters.sheet has the
    /// lenses' own pitch.
    std::optional<double> visual_pitch;
    std::set<std::string> given;     ///< the words that have been given, to detect repetition
    double look_at_distance = 0;     ///< |look_at - location|, scene units; 0: no look_at
    double sheet_distance_ratio = 0; ///< sheet distance / |direction|; 0: not known yet
    double direction = 0;            ///< |direction| before the camera's transforms
    std::vector<double> distances;   ///< result of Probe_Integral_Depths, after parsing
    std::string fit_words;           ///< the words that the fit chose; empty: no fit
    bool orthographic = false; ///< right and up are the window at any distance, not at |direction|
    int draft = 1;             ///< Integral_Draft=
    std::optional<integral::Vec2> draft_pitch; ///< a draft's pixel pitch in place of the film's, mm
    std::shared_ptr<const integral::IntegralCamera> optics; ///< with the camera's final transform;
                                                            ///< null until the frame size is known
    struct Position
    {
        UCS2String file;
        POV_LONG line = 0, column = 0, offset = 0;
    } end; ///< of the statement; without a file: there is no statement
};

/// A view that is being rendered: its optics and the data that its threads share.
struct IntegralView
{
    std::shared_ptr<const integral::IntegralCamera> optics;
    std::shared_ptr<const integral::PixelSampler> sampler;
    /// The camera and the sampler of anti-aliasing's pixels: a panel's colour stripes, if the frame
    /// is reconstructed (IntegralStripes); else those of the frame.
    std::shared_ptr<const integral::IntegralCamera> sampled_optics;
    std::shared_ptr<const integral::PixelSampler> sampled_sampler;
    std::shared_ptr<const integral::QuiltSampler> quilt; ///< null: the picture is a frame
    std::shared_ptr<IntegralCounts> counts;
    std::shared_ptr<IntegralShadingCache> shading_cache; ///< null: rays do not share shading
    std::shared_ptr<IntegralShadingCache> ambient_cells; ///< null: rays do not share radiosity's ambient
                                                         ///< light
    bool cache_expensive_shading_only = false;      ///< use the cache only where shading is expensive
    std::shared_ptr<IntegralSampling> sampling; ///< null: no anti-aliasing
    std::shared_ptr<IntegralAudit> audit;       ///< null: no audit
    std::shared_ptr<IntegralDepth> depth;       ///< null: no depth frame
    IntegralErrorOptions error;
    pov_base::IntegralClipping clipping; ///< of the light of each ray
    std::uint64_t seed = 0;     ///< Integral_Seed=
    pov_base::IntegralRows rows; ///< the rows that count (Integral_Rows=)

    /// The lattice in whose axes rays are stored: of a frame, the sheet's; of a quilt, an upright
    /// one.
    const integral::Lattice& Lattice() const
    {
        return quilt ? quilt->upright() : optics->optics.lattice();
    }
};

/// The optics for a frame of width x height pixels, from the statement and the vectors of `camera`.
/// Throws std::invalid_argument with a message for the user.
std::shared_ptr<const integral::IntegralCamera> Make_Integral_Optics(const Camera& camera,
                                                                     int width, int height);

/// Distance of the scene's own eye from the sheet, mm. Call it for a camera that has its optics.
double Integral_Scene_Distance(const Camera& camera);

/// Chooses how the scene's objects are bounded if the options leave that open. Call it after the
/// scene is parsed. For an integral camera, whose rays have many origins and directions, a BSP tree
/// (+BM2) is faster to traverse than a hierarchy of bounding boxes, but takes longer to build; it
/// is chosen if that pays. Other cameras get POV-Ray's default.
void Choose_Integral_Bounding(SceneData& scene);

/// Gives a view's camera its optics, its sampler and new counts, and passes the geometry to the
/// code that writes the picture. Call it when the camera and the size are final. No effect on other
/// cameras.
void Start_Integral_View(Camera& camera, const SceneData& scene, int width, int height,
                         POVMS_Object& options);

/// The number of tasks that a view must run after rendering: `threads` for a depth frame and
/// `threads` for an audit.
int Integral_Final_Tasks(const Camera& camera, int threads);
RenderTask *New_Integral_Final_Task(ViewData *view, int index); ///< index from 0

/// Adds the counts and the error to a view's statistics message. Call it after rendering. No effect
/// on other cameras.
void Get_Integral_Statistics(const Camera& camera, POVMS_Object& statistics);

}

#endif
