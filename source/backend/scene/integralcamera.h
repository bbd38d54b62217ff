// SPDX-License-Identifier: AGPL-3.0-or-later
// The integral camera as a scene carries it: what the camera statement said, and the optics made
// of it. Camera holds a pointer to one of these; a camera without is POV-Ray's own.
#ifndef POVRAY_BACKEND_INTEGRALCAMERA_H
#define POVRAY_BACKEND_INTEGRALCAMERA_H

#include <atomic>
#include <list>
#include <memory>
#include <mutex>
#include <set>
#include <string>

#include "integral/optics/camera.h"

class POVMS_Object;

namespace pov
{

class Camera;

/// Counts of one thread of a render, which alone writes them. All are of camera rays of the
/// picture itself; radiosity's pretrace is left out.
struct IntegralTally
{
    std::atomic<long long> film_points{0}, rays{0}, searched{0}, outside_aperture{0}, total_reflection{0};
};

/// The tallies of a render's threads.
struct IntegralCounts
{
    std::mutex mutex;
    std::list<IntegralTally> tallies; ///< list: a thread keeps a reference to its own
};

/// Immutable once the camera statement has been parsed; copies of a camera share it.
struct IntegralBlock
{
    bool integral = false;                 ///< false: only notes for Integral_Camera= to use
    integral::CameraParameters parameters;
    std::set<std::string> given;           ///< the words that have been given, to refuse a second
    double look_at_distance = 0;           ///< |look_at - location|, scene units; 0: no look_at
    double sheet_distance_ratio = 0;       ///< sheet distance / |direction|; 0: not known yet
    std::shared_ptr<const integral::IntegralCamera> optics; ///< of the camera's last transform
    std::shared_ptr<IntegralCounts> counts;
};

/// The block's optics for a frame of width x height pixels, from the vectors of `camera`.
/// Throws std::invalid_argument with a sentence for the user.
std::shared_ptr<const integral::IntegralCamera> Make_Integral_Optics(const Camera& camera, int width, int height);

/// To be called once a view's camera and size are settled: gives it optics of its own and fresh
/// counts, and announces its geometry to whoever writes the picture. No effect on other cameras.
void Start_Integral_View(Camera& camera, int width, int height);

/// Adds the counts to a view's statistics message. No effect on other cameras.
void Get_Integral_Statistics(const Camera& camera, POVMS_Object& statistics);

}

#endif
