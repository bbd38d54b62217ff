// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/render/integraldepth.h"
#include "backend/render/integralprobes.h"
#include "backend/render/ray.h"
#include "backend/scene/camera.h"
#include "backend/scene/integralcamera.h"
#include "backend/scene/scene.h"
#include "backend/scene/view.h"
#include "base/integralframe.h"
#include "base/integralpicture.h"

#include <cmath>
#include <limits>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

namespace
{

/// Accepts objects that the camera sees as surfaces.
struct SurfaceCondition : NoSomethingFlagRayObjectCondition
{
    bool operator()(const Ray& ray, const ObjectBase *object, DBL data) const override
    {
        return Is_Integral_Surface(object) &&
               NoSomethingFlagRayObjectCondition::operator()(ray, object, data);
    }
};

}

IntegralDepth::IntegralDepth(const IntegralView& view, const std::string& file,
                             const std::vector<double>& distances)
    : optics(view.optics),
      sampler(view.sampler),
      quilt(view.quilt),
      file(file),
      distances(distances.begin(), distances.end()),
      depths(std::size_t(optics->film.width) * optics->film.height,
             std::numeric_limits<float>::quiet_NaN())
{
}

bool IntegralDepth::Next_Row(int& row)
{
    row = next++;
    return row < optics->film.height;
}

void IntegralDepth::Find_Row(int row, Trace& trace)
{
    const SurfaceCondition seen;
    const TrueRayObjectCondition any;
    for (int x = 0; x < optics->film.width; x++)
    {
        const integral::Vec2 centre{x + 0.5, row + 0.5};
        const auto sight = quilt ? quilt->ray(centre) : sampler->pole_ray(centre);
        if (!sight)
            continue;
        const integral::SightLine line = integral::sight_line(*optics, *sight);
        Ray ray;
        Make_Vector(ray.Origin, line.origin.x, line.origin.y, line.origin.z);
        Make_Vector(ray.Direction, line.direction.x, line.direction.y, line.direction.z);
        Intersection met;
        if (line.length > 0)
            met.Depth = line.length;
        float& depth = depths[std::size_t(row) * optics->film.width + x];
        depth = std::numeric_limits<float>::infinity();
        if (trace.FindIntersection(met, ray, seen, any))
            depth = float(
                seen_from_scene(*optics, line.origin + met.Depth * line.direction).z);
    }
}

void IntegralDepth::Write() const
{
    const std::string error = pov_base::Write_Integral_Depth(
        file, optics->film.width, optics->film.height, depths, distances);
    if (!error.empty())
        pov_base::IntegralFrame::Add_Problem("Integral_Depth_Image", error);
}

IntegralDepthTask::IntegralDepthTask(ViewData *view)
    : IntegralTask(view, false), depth(view->GetCamera().Integral_View->depth)
{
}

void IntegralDepthTask::Run()
{
    int row;
    while (depth->Next_Row(row))
    {
        depth->Find_Row(row, trace);
        Cooperate();
    }
}

}
