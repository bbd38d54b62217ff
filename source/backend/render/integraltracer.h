// SPDX-License-Identifier: AGPL-3.0-or-later
// One thread's share of an integral camera: makes its camera rays and counts them.
#ifndef POVRAY_BACKEND_INTEGRALTRACER_H
#define POVRAY_BACKEND_INTEGRALTRACER_H

#include <memory>
#include <vector>

namespace pov
{

class Camera;
class ObjectBase;
class Ray;
class TraceThreadData;
struct IntegralBlock;
struct IntegralTally;

class IntegralTracer
{
    public:
        /// Takes on a camera; one that is not integral leaves Active() false. `objects` are the scene's.
        void Setup(const Camera& camera, const std::vector<ObjectBase *>& objects, TraceThreadData *thread);

        bool Active() const { return active; }

        /// Whether a ray may start inside an object, so that its containers have to be looked for.
        bool May_Start_Inside() const { return may_start_inside; }

        /// The camera ray of film point (px, py), in pixels from the frame's top-left corner, and
        /// how far along it the camera sees (scene units; 0 = without end).
        /// `counted`: whether the statistics are to know of it.
        /// False where the film point images nothing: no ray is to be traced.
        bool Create_Ray(Ray& ray, double px, double py, bool counted, double& length);

    private:
        std::shared_ptr<const IntegralBlock> block;
        IntegralTally* tally = nullptr; ///< in the block's counts, if it keeps any (a clockless animation's cameras do not)
        bool active = false;
        bool may_start_inside = true;
};

}

#endif
