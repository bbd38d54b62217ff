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

bool Is_Integral_Surface(const ObjectBase *object)
{
    const bool is_container = Test_Flag(object, HOLLOW_FLAG) && object->interior != NULL &&
                              !object->interior->media.empty();
    return !is_container && !Test_Flag(object, NO_IMAGE_FLAG);
}

namespace
{

using integral::Vec2;
using integral::Vec3;

/// The visible objects whose bounding boxes meet the region of the aperture.
std::vector<ObjectPtr> Objects_Near(const integral::StartRegion& region, const SceneData& scene)
{
    std::vector<ObjectPtr> near;
    for (const ObjectPtr object : scene.objects)
        if (Is_Integral_Surface(object) && Region_Meets(region, object->BBox))
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

/// Looks from the eye to points of the aperture, for a limited processor time, so that other work
/// on the machine does not change the result.
struct Look
{
    const integral::IntegralCamera& camera;
    TraceThreadData *thread;
    std::vector<ObjectPtr> near;
    std::clock_t end = std::clock() + CLOCKS_PER_SEC / 50;

    bool Time_Left() const { return std::clock() < end; }
    Vec3 Scene_Point(Vec2 point) const
    {
        return *scene_from_seen(camera, {point.x, point.y, -camera.optics.aperture().distance});
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

/// Fraction of the rays that start behind a surface, seen from the eye.
double Parted_Rays(const Look& look)
{
    int rays = 0, blocked_share = 0;
    Visit_Rays(look,
               [&](const auto& ray)
               {
                   rays++;
                   blocked_share += look.Is_Parted(ray.aperture_point);
               });
    return rays > 0 ? double(blocked_share) / rays : 0;
}

/// Share of the aperture's width and height, about its middle, that is free: it grows by a twentieth at a
/// time, until a tested point on the edge of that part is behind a surface.
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

ApertureObstruction Probe_Integral_Starts(const integral::IntegralCamera& camera, const SceneData& scene,
                                     TraceThreadData *thread)
{
    const integral::Aperture& aperture = camera.optics.aperture();
    const Vec2 half{0.5 * aperture.width, 0.5 * aperture.height};
    ApertureObstruction starts;
    if (camera.pseudoscopic || camera.projection ||
        (camera.depth_range && camera.depth_range->x < aperture.distance))
        return starts;
    Look look{camera, thread, {}};
    const Vec3 middle = look.Scene_Point({0, 0});
    look.near = Objects_Near({middle, look.Scene_Point({half.x, 0}) - middle,
                              look.Scene_Point({0, half.y}) - middle},
                             scene);
    if (look.near.empty())
        return starts;
    starts.blocked_share = Parted_Rays(look);
    if (starts.blocked_share > 0)
        starts.clear = Clear_Part(look, half);
    return starts;
}

namespace
{

/// Whether a ray may meet a box. No component of `direction` may be a NaN.
bool May_Meet(const Vec3& origin, const Vec3& direction, const BBOX& box)
{
    const double from[3] = {origin.x, origin.y, origin.z},
                 way[3] = {direction.x, direction.y, direction.z};
    double near = 0, far = HUGE_VAL;
    for (int axis = X; axis <= Z; axis++)
    {
        const double low = box.Lower_Left[axis], length = box.Lengths[axis],
                     slack = 1e-5 * (std::fabs(low) + length + std::fabs(from[axis])); // BBOX is in
                                                                                        // floats
        const double ends[2] = {low - slack - from[axis], low + length + slack - from[axis]};
        if (way[axis] == 0)
        {
            if (ends[0] > 0 || ends[1] < 0)
                return false;
            continue;
        }
        const double a = ends[0] / way[axis], b = ends[1] / way[axis];
        near = std::max(near, std::min(a, b));
        far = std::min(far, std::max(a, b));
    }
    return near <= far;
}

/// Distance along the ray to the first visible surface; HUGE_VAL if there is none.
double First_Surface(const Ray& ray, const Vec3& origin, const Vec3& direction, const SceneData& scene,
                     TraceThreadData *thread)
{
    double nearest = HUGE_VAL;
    for (const ObjectPtr object : scene.objects)
    {
        if (!Is_Integral_Surface(object) || !May_Meet(origin, direction, object->BBox))
            continue;
        Intersection found;
        if (Find_Intersection(&found, object, ray, thread) && found.Depth < nearest)
            nearest = found.Depth;
    }
    return nearest;
}

}

std::vector<double> Probe_Integral_Depths(const integral::IntegralCamera& camera,
                                          const SceneData& scene, TraceThreadData *thread)
{
    constexpr double least = 200, most = 2000, tests = 5e7;
    const double pixels = double(camera.film.width) * camera.film.height;
    const double affordable = std::min(tests / (1.0 + scene.objects.size()), pixels / 50);
    const int count = int(std::min(pixels, std::min(most, std::max(least, affordable))));
    const double eye = camera.parallax ? camera.parallax->scene_distance : viewer_distance(camera),
                 magnified = camera.projection ? -camera.projection->magnification() : 1;
    const Vec3 origin = scene_from_sheet(camera.placement, {0, 0, -eye});
    std::vector<double> distances;
    for (int k = 0; k < count; k++)
    {
        const Vec2 point = magnified *
                           film_from_pixel(camera.film, spread_pixel(camera.film, k, count));
        const Vec3 to_sheet = scene_from_sheet(camera.placement, {point.x, point.y, 0}) - origin,
                   direction = (1 / length(to_sheet)) * to_sheet;
        const double depth = First_Surface(Ray_Along(origin, direction), origin, direction, scene,
                                           thread);
        // The eye plane is parallel to the sheet: the same part of every ray lies before the sheet.
        distances.push_back(float(depth * eye * length(camera.placement.z) / length(to_sheet)));
    }
    return distances;
}
}
