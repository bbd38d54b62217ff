// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/render/integraltracer.h"
#include "backend/render/integralcontainers.h"
#include "backend/render/ray.h"
#include "backend/scene/camera.h"
#include "backend/scene/integralcamera.h"

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

/// Adds to a counter that no other thread writes: no locked instruction is needed.
static void Add(std::atomic<long long>& counter, bool one)
{
    counter.store(counter.load(std::memory_order_relaxed) + one, std::memory_order_relaxed);
}

void IntegralTracer::Setup(const Camera& camera, const std::vector<ObjectBase *>& objects, TraceThreadData *thread)
{
    block = camera.Integral;
    active = block && block->integral && block->optics;
    tally = nullptr;
    may_start_inside = active && pov::May_Start_Inside(*block->optics, objects, thread);
    if (active && block->counts)
    {
        std::lock_guard<std::mutex> lock(block->counts->mutex);
        tally = &block->counts->tallies.emplace_back();
    }
}

bool IntegralTracer::Create_Ray(Ray& ray, double px, double py, bool counted, double& length)
{
    const integral::IntegralCamera& camera = *block->optics;

    // film point -> lens -> line through its pole
    const integral::Vec2 film_point = integral::film_from_pixel(camera.film, {px, py});
    const integral::MappedPoint mapped = camera.optics.map(film_point, camera.mapping);
    if (counted && tally)
    {
        Add(tally->film_points, true);
        Add(tally->rays, mapped.ray.has_value());
        Add(tally->searched, mapped.ray.has_value() && mapped.searched);
        Add(tally->outside_aperture, mapped.empty == integral::Empty::outside_aperture);
        Add(tally->total_reflection, mapped.empty == integral::Empty::total_reflection);
    }
    if (!mapped.ray)
        return false;

    // the one ray that sees along that line what the viewer would
    const integral::SightLine line = integral::sight_line(camera, *mapped.ray);
    Make_Vector(ray.Origin, line.origin.x, line.origin.y, line.origin.z);
    Make_Vector(ray.Direction, line.direction.x, line.direction.y, line.direction.z);
    length = line.length;
    return true;
}

}
