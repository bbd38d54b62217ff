// SPDX-License-Identifier: AGPL-3.0-or-later
// Which objects a camera ray of an integral camera can start inside of.
#ifndef POVRAY_BACKEND_INTEGRALCONTAINERS_H
#define POVRAY_BACKEND_INTEGRALCONTAINERS_H

#include <vector>

#include "backend/frame.h"
#include "integral/optics/camera.h"

namespace pov
{

class Ray;
class SceneData;

/// The objects of a scene that may contain the start of a camera ray; none if no interior among
/// them makes a difference to a ray inside of it. Chosen once for a view, so that its rays are held
/// against these alone.
class IntegralContainers
{
public:
    void Choose(const integral::IntegralCamera& camera, SceneData& scene, TraceThreadData *thread);

    /// No ray starts inside of anything that matters.
    bool None() const { return candidates.empty(); }

    /// POV-Ray's own search is to be used: with +BM2 it alone knows the order of the objects, and
    /// for a ray that may start anywhere its tree is faster.
    bool Left_To_POV() const { return left_to_pov && !None(); }

    int Number() const { return int(candidates.size()); }

    /// Tells the ray which of them its origin is inside of, in the order in which POV-Ray's own
    /// search finds them.
    void Tell(Ray& ray, TraceThreadData *thread) const;

private:
    void Choose_From(BBOX_TREE *node, const std::vector<ObjectPtr>& chosen);

    std::vector<ObjectPtr> candidates;
    bool left_to_pov = false;
};

}

#endif
