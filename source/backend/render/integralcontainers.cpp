// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/render/integralcontainers.h"
#include "backend/render/ray.h"
#include "backend/scene/objects.h"
#include "backend/scene/scene.h"
#include "backend/shape/planes.h"

#include <algorithm>
#include <cmath>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

using integral::StartRegion;
using integral::Vec3;

/// Applies the separating axis theorem: box and region meet unless a plane separates them that is parallel to
/// a face of the box, to the region, or to both an edge of the box and one of the region.
bool Region_Meets(const StartRegion& region, const BBOX& box)
{
    const Vec3 low{box.Lower_Left[X], box.Lower_Left[Y], box.Lower_Left[Z]};
    const Vec3 half{0.5 * box.Lengths[X], 0.5 * box.Lengths[Y], 0.5 * box.Lengths[Z]}; // single
                                                                                       // precision
    const Vec3 between = low + half - region.centre;
    const double slack = 1e-6 * (length(low) + length(half) + length(region.centre));
    const auto parts = [&](Vec3 axis)
    {
        const double reach = half.x * std::fabs(axis.x) + half.y * std::fabs(axis.y) +
                             half.z * std::fabs(axis.z) + std::fabs(dot(region.half_x, axis)) +
                             std::fabs(dot(region.half_y, axis));
        return std::fabs(dot(between, axis)) > reach + slack * length(axis);
    };
    const Vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    if (parts(cross(region.half_x, region.half_y)))
        return false;
    for (const Vec3& axis : axes)
        if (parts(axis) || parts(cross(axis, region.half_x)) || parts(cross(axis, region.half_y)))
            return false;
    return true;
}

namespace
{

/// Whether the interior changes a ray that is inside this object only.
bool Matters(const Interior& interior)
{
    return !interior.hollow || interior.IOR != 1.0f || interior.Dispersion != 1.0f ||
           interior.Old_Refract != 1.0f || interior.Fade_Power != 0.0f || !interior.media.empty() ||
           interior.subsurface != NULL;
}

/// Whether an object may contain a point of the region. For a plane it is enough to test the four
/// corners: its outside is convex, so if they are outside, the whole region is.
bool May_Contain(const ObjectPtr object, const StartRegion& region, TraceThreadData *thread)
{
    if (!Region_Meets(region, object->BBox))
        return false;
    if (dynamic_cast<const Plane *>(object) == NULL || !object->Clip.empty())
        return true;
    for (const double a : {-1.0, 1.0})
        for (const double b : {-1.0, 1.0})
        {
            const Vec3 corner = region.centre + a * region.half_x + b * region.half_y;
            const VECTOR point = {corner.x, corner.y, corner.z};
            if (object->Inside(point, thread))
                return true;
        }
    return false;
}

}

void EnclosingObjects::Choose(const integral::IntegralCamera& camera, SceneData& scene,
                                TraceThreadData *thread)
{
    const auto region = start_region(camera);
    std::vector<ObjectPtr> chosen;
    for (const ObjectPtr object : scene.objects)
        if (object->interior != NULL && (!region || May_Contain(object, *region, thread)))
            chosen.push_back(object);
    // If one interior affects rays, the others count too: when a ray leaves an overlap of objects,
    // the result depends on all objects that it is inside.
    if (std::none_of(chosen.begin(), chosen.end(),
                     [](const ObjectPtr object) { return Matters(*object->interior); }))
        chosen.clear();

    left_to_pov = scene.boundingMethod == 2 ||
                  !region; // faster with a tree than with a list of all objects
    candidates.clear();
    if (scene.boundingMethod == 0 || scene.boundingSlabs == NULL || left_to_pov)
        candidates = chosen;
    else
        Choose_From(scene.boundingSlabs, chosen);
}

/// Appends the chosen objects below a node, in the order in which POV-Ray visits the tree.
void EnclosingObjects::Choose_From(BBOX_TREE *node, const std::vector<ObjectPtr>& chosen)
{
    if (node->Entries == 0)
    {
        const ObjectPtr object = ObjectPtr(node->Node);
        if (std::find(chosen.begin(), chosen.end(), object) != chosen.end())
            candidates.push_back(object);
        return;
    }
    for (int i = 0; i < node->Entries; i++)
        Choose_From(node->Node[i], chosen);
}

void EnclosingObjects::Add_Interiors(Ray& ray, TraceThreadData *thread) const
{
    for (const ObjectPtr object : candidates)
        if (Inside_BBox(ray.Origin, object->BBox) && object->Inside(ray.Origin, thread))
            ray.AppendInterior(object->interior);
}

}
