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
class EnclosingObjects
{
public:
    void Choose(const integral::IntegralCamera& camera, SceneData& scene, TraceThreadData *thread);

    /// Whether no ray starts inside an object whose interior affects it.
    bool None() const { return candidates.empty(); }

    /// Whether POV-Ray's own search must be used. It is needed with +BM2, where nothing else can
    /// find the order of the objects, and it is faster for rays that may start anywhere.
    bool Use_Generic_Search() const { return left_to_pov && !None(); }

    int Number() const { return int(candidates.size()); }

    /// Adds the interiors that contain the ray's origin to its list, in the order in which
    /// POV-Ray's own search finds them.
    void Add_Interiors(Ray& ray, TraceThreadData *thread) const;

private:
    void Choose_From(BBOX_TREE *node, const std::vector<ObjectPtr>& chosen);

    std::vector<ObjectPtr> candidates;
    bool left_to_pov = false;
};

}

#endif
