// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds the objects inside which camera rays of an integral camera start.
#ifndef POVRAY_BACKEND_INTEGRALCONTAINERS_H
#define POVRAY_BACKEND_INTEGRALCONTAINERS_H

#include <vector>

#include "backend/frame.h"
#include "integral/optics/camera.h"

namespace pov
{

class Ray;
class SceneData;

/// Whether a region and a bounding box intersect.
bool Region_Meets(const integral::StartRegion& region, const BBOX& box);

/// The objects of a scene that may contain the start of a camera ray; none if no interior among
/// them affects a ray. They are chosen once for a view, so that each ray is tested against these
/// only.
class IntegralContainers
{
public:
    void Choose(const integral::IntegralCamera& camera, SceneData& scene, TraceThreadData *thread);

    /// Whether no ray starts inside an object whose interior affects it.
    bool None() const { return candidates.empty(); }

    /// Whether POV-Ray's own search must be used. It is needed with +BM2, where the order of the
    /// objects is known only to it, and it is faster for rays that may start anywhere.
    bool Left_To_POV() const { return left_to_pov && !None(); }

    int Number() const { return int(candidates.size()); }

    /// Adds to the ray's list of interiors those that contain its origin, in the order in which
    /// POV-Ray's own search finds them.
    void Tell(Ray& ray, TraceThreadData *thread) const;

private:
    void Choose_From(BBOX_TREE *node, const std::vector<ObjectPtr>& chosen);

    std::vector<ObjectPtr> candidates;
    bool left_to_pov = false;
};

}

#endif
