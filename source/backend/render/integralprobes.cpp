// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/render/integralprobes.h"
#include "backend/render/integralcontainers.h"
#include "backend/render/ray.h"
#include "backend/scene/integralcamera.h"
#include "backend/scene/objects.h"
#include "backend/scene/scene.h"
#include "integral/optics/coverage.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iterator>
#include <vector>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

namespace
{

using integral::Vec2;
using integral::Vec3;

/// Whether the camera sees an object as a surface: not one without an image, nor a container of
/// media.
bool Is_Seen(ObjectPtr object)
{
    const bool is_container = Test_Flag(object, HOLLOW_FLAG) && object->interior != NULL &&
                              !object->interior->media.empty();
    return !is_container && !Test_Flag(object, NO_IMAGE_FLAG);
}

/// The seen objects near the aperture.
std::vector<ObjectPtr> Objects_Near(const integral::StartRegion& region, const SceneData& scene)
{
    std::vector<ObjectPtr> near;
    for (const ObjectPtr object : scene.objects)
        if (Is_Seen(object) && Region_Meets(region, object->BBox))
            near.push_back(object);
    return near;
}

Ray Ray_Along(Vec3 origin, Vec3 direction)
{
    Ray ray;
    Make_Vector(ray.Origin, origin.x, origin.y, origin.z);
    Make_Vector(ray.Direction, direction.x, direction.y, direction.z);
    return ray;
}

/// Whether a surface of one of the objects is between two points.
bool Are_Parted(Vec3 from, Vec3 to, const std::vector<ObjectPtr>& objects, TraceThreadData *thread)
{
    const double distance = length(to - from);
    if (!(distance > 0))
        return false;
    const Ray ray = Ray_Along(from, (1 / distance) * (to - from));
    return std::any_of(objects.begin(), objects.end(),
                       [&](const ObjectPtr object)
                       {
                           Intersection found;
                           return Find_Intersection(&found, object, ray, thread) &&
                                  found.Depth < distance;
                       });
}

/// Looks from the eye to points of the aperture, for some processor time: what else the machine
/// does changes no finding.
struct Look
{
    const integral::IntegralCamera& camera;
    TraceThreadData *thread;
    std::vector<ObjectPtr> near;
    std::clock_t end = std::clock() + CLOCKS_PER_SEC / 50;

    bool Time_Left() const { return std::clock() < end; }
    Vec3 Scene_Point(Vec2 point) const
    {
        return scene_from_sheet(camera.placement,
                                {point.x, point.y, -camera.optics.aperture().distance});
    }
    bool Is_Parted(Vec2 point) const
    {
        return Are_Parted(Scene_Point({0, 0}), Scene_Point(point), near, thread);
    }
};

/// Calls `visit` with the rays of at most 128 film points while there is time left.
template <class Visit> void Visit_Rays(const Look& look, Visit visit)
{
    const integral::Film& film = look.camera.film;
    const int most = int(std::min(128.0, double(film.width) * film.height));
    for (int k = 0; k < most && look.Time_Left(); k++)
    {
        const Vec2 point = film_from_pixel(film, spread_pixel(film, k, most));
        if (const auto ray = look.camera.optics.map(point, look.camera.mapping).ray)
            visit(*ray);
    }
}

/// The share of the rays that start at a parted point.
double Parted_Rays(const Look& look)
{
    int rays = 0, parted = 0;
    Visit_Rays(look,
               [&](const auto& ray)
               {
                   rays++;
                   parted += look.Is_Parted(ray.aperture_point);
               });
    return rays > 0 ? double(parted) / rays : 0;
}

/// How large a part of the aperture about its middle has no parted point on its edge, in
/// twentieths of its width and height.
double Clear_Part(const Look& look, Vec2 half)
{
    constexpr int steps = 20, around = 24;
    for (int step = 1; step <= steps && look.Time_Left(); step++)
        for (int k = 0; k < around; k++)
        {
            const double angle = 2 * M_PI * (k + 0.5) / around, c = std::cos(angle),
                         s = std::sin(angle), to_edge = 1 / std::max(std::fabs(c), std::fabs(s));
            const double part = double(step) / steps * to_edge;
            if (look.Is_Parted({part * c * half.x, part * s * half.y}))
                return double(step - 1) / steps;
        }
    return 1;
}

}

IntegralStarts Probe_Integral_Starts(const integral::IntegralCamera& camera, const SceneData& scene,
                                     TraceThreadData *thread)
{
    const integral::Aperture& aperture = camera.optics.aperture();
    const Vec2 half{0.5 * aperture.width, 0.5 * aperture.height};
    IntegralStarts starts;
    if (camera.pseudoscopic || camera.projection ||
        (camera.depth_range && camera.depth_range->x < aperture.distance))
        return starts;
    Look look{camera, thread, {}};
    look.near = Objects_Near(
        {look.Scene_Point({0, 0}), half.x * camera.placement.x, half.y * camera.placement.y},
        scene);
    if (look.near.empty())
        return starts;
    starts.parted = Parted_Rays(look);
    if (starts.parted > 0)
        starts.clear = Clear_Part(look, half);
    return starts;
}

std::vector<double> Probe_Integral_Depths(const integral::IntegralCamera& camera,
                                          const SceneData& scene, TraceThreadData *thread)
{
    Look look{camera, thread, {}};
    std::copy_if(scene.objects.begin(), scene.objects.end(), std::back_inserter(look.near),
                 Is_Seen);
    std::vector<double> depths;
    Visit_Rays(
        look,
        [&](const auto& mapped)
        {
            const integral::SightLine line = sight_line(camera, integral::pole_beam(mapped));
            const Ray ray = Ray_Along(line.origin, line.direction);
            double nearest = HUGE_VAL;
            for (const ObjectPtr object : look.near)
            {
                Intersection found;
                if (Find_Intersection(&found, object, ray, thread))
                    nearest = std::min(nearest, double(found.Depth));
            }
            depths.push_back(
                nearest < HUGE_VAL
                    ? sheet_from_scene(camera.placement, line.origin + nearest * line.direction).z
                    : HUGE_VAL);
        });
    std::sort(depths.begin(), depths.end());
    return depths;
}
}
