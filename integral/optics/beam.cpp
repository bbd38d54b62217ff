// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/optics/beam.h"

#include <algorithm>

namespace integral {

namespace {

/// Whether the squares of the coordinates do not overflow and that of z does not underflow.
bool has_safe_squares(Vec3 point)
{
    constexpr double most = 1e150;
    return std::max({std::fabs(point.x), std::fabs(point.y), std::fabs(point.z)}) < most &&
           std::fabs(point.z) > 1 / most;
}

/// Geometry of the refraction where light leaves a lens.
struct Exit {
    Vec2 across, along; // the directions b and a of lens_surface.h
    Vec2 beside;        // lateral shift of the ideal beam's ray from the pole ray; else 0
    TangentPlane plane;
};

bool is_lenticular(const SheetOptics& optics)
{
    return optics.sheet().arrangement == Arrangement::lenticular;
}

/// The exit at `offset` from a lens's pole (axis). Empty where the lens has no surface.
std::optional<Exit> exit_at(const SheetOptics& optics, Vec2 offset)
{
    Exit exit;
    const bool curved = refracts_at_surface(optics.model());
    double v = length(offset);
    if (is_lenticular(optics)) {
        exit.across = optics.slit().across;
        exit.along = optics.slit().axis;
        v = dot(exit.across, offset);
    } else {
        exit.across = curved && v > 0 ? (1 / v) * offset : Vec2{1, 0};
        exit.along = {-exit.across.y, exit.across.x};
    }
    if (!curved) {
        exit.beside = offset;
        return exit;
    }
    const auto plane = tangent_plane(surface_radius(optics.sheet()), v);
    if (!plane)
        return std::nullopt;
    exit.plane = *plane;
    return exit;
}

/// `refracted`: the ray's unit direction times `way`.
BeamRay make_ray(Vec2 point, double height, Vec3 refracted, double way, Vec2 aperture_point)
{
    return {{point.x, point.y, height}, (1 / way) * refracted, aperture_point};
}

/// The ray through a lenticular lens. `depth`: distance of the exit from the film along z, mm.
BeamRay beam_of(const SlitRay& ray, const Exit& exit, double depth)
{
    return make_ray(ray.point + exit.beside, exit.plane.height, ray.refracted,
                    std::sqrt(dot(ray.offset, ray.offset) + depth * depth),
                    ray.aperture_point + exit.beside);
}

Vec2 leaving_point(const SheetOptics& optics, Vec3 scene_point, LensIndex lens,
                   const LensPoint& point, const Exit& exit)
{
    const Vec2 from = optics.lattice().pole(lens) + point.offset;
    if (!is_lenticular(optics))
        return from;
    const Slit& slit = optics.slit();
    const double behind = scene_point.z - exit.plane.height,
                 before = slit.distance + exit.plane.height, way = scene_point.z + slit.distance,
                 eta = signed_height(slit, point.slit) + dot(slit.normal, exit.beside);
    const double across_slit = (eta * behind +
                                dot(slit.normal, Vec2{scene_point.x, scene_point.y}) * before) /
                               way;
    return from +
           ((across_slit - dot(slit.normal, from)) / dot(slit.normal, slit.axis)) * slit.axis;
}

} // namespace

Vec2 leaving_point(const SheetOptics& optics, Vec3 scene_point, LensIndex lens,
                   const LensPoint& point)
{
    const auto exit = exit_at(optics, point.offset);
    return leaving_point(optics, scene_point, lens, point, exit ? *exit : Exit{});
}

std::optional<BeamRay> beam_ray(const SheetOptics& optics, Vec2 film_point, LensIndex lens,
                                const LensPoint& point)
{
    const auto exit = exit_at(optics, point.offset);
    if (!exit)
        return std::nullopt;
    const Medium& medium = optics.medium();
    const Vec2 pole = optics.lattice().pole(lens);
    const double depth = medium.t - exit->plane.height;
    if (is_lenticular(optics)) {
        const Slit& slit = optics.slit();
        const auto ray = slit_ray(slit, medium, film_point, pole, signed_height(slit, point.slit),
                                  exit->plane);
        return ray ? std::optional(beam_of(*ray, *exit, depth)) : std::nullopt;
    }
    const Vec2 to_pole = pole - film_point;
    const double reach = dot(exit->across, to_pole) + exit->plane.v,
                 along = dot(exit->along, to_pole);
    const Incidence way = incidence(medium, exit->plane, reach);
    const double clear = clearance(medium, way, along);
    if (!(clear > 0) || !(way.normal > 0))
        return std::nullopt;
    const Vec3 out = refracted(medium, exit->plane, way, along, std::sqrt(clear));
    if (!(out.z < 0))
        return std::nullopt;
    const Vec2 lateral = out.x * exit->across + out.y * exit->along;
    const double stretch = (optics.aperture().distance + exit->plane.height) / -out.z;
    const Vec2 from = pole + point.offset;
    return make_ray(from, exit->plane.height, {lateral.x, lateral.y, out.z},
                    std::sqrt(reach * reach + along * along + depth * depth),
                    from + stretch * lateral);
}

void beam_rays(const SheetOptics& optics, int number, const RayRun<Vec2>& film_points,
               LensIndex lens, const RayRun<LensPoint>& points,
               RayRun<std::optional<BeamRay>>& rays)
{
    if (!is_lenticular(optics) || refracts_at_surface(optics.model())) {
        for (int k = 0; k < number; ++k)
            rays[k] = beam_ray(optics, film_points[k], lens, points[k]);
        return;
    }
    RayRun<Vec2> poles;
    poles.fill(optics.lattice().pole(lens));
    RayRun<double> etas{};
    for (int k = 0; k < number; ++k)
        etas[k] = signed_height(optics.slit(), points[k].slit);
    RayRun<std::optional<SlitRay>> found;
    slit_rays(optics.slit(), optics.medium(), number, film_points, poles, etas, found);
    for (int k = 0; k < number; ++k) {
        Exit exit;
        exit.beside = points[k].offset;
        rays[k] = found[k] ? std::optional(beam_of(*found[k], exit, optics.medium().t))
                           : std::nullopt;
    }
}

std::optional<Vec2> film_point_imaging(const SheetOptics& optics, Vec3 scene_point, LensIndex lens,
                                       const LensPoint& point)
{
    // The pole's own ray, which most calls request, needs no surface.
    if (!is_lenticular(optics) && point.offset.x == 0 && point.offset.y == 0 &&
        has_safe_squares(scene_point))
        return film_point_through_pole(optics.medium(), optics.lattice().pole(lens), scene_point);
    const auto exit = exit_at(optics, point.offset);
    if (!exit)
        return std::nullopt;
    const Vec2 scene{scene_point.x, scene_point.y};
    const double behind = scene_point.z - exit->plane.height;
    const Vec2 from = leaving_point(optics, scene_point, lens, point, *exit);

    const Vec2 lateral = scene - from;
    const double largest = std::max(
        {std::fabs(lateral.x), std::fabs(lateral.y), std::fabs(behind)});
    const Vec3 line = ((behind > 0 ? -1 : 1) / largest) * Vec3{lateral.x, lateral.y, behind};
    const Vec3 direction = (1 / length(line)) * line; // towards the viewer
    if (!(direction.z < 0))
        return std::nullopt;
    const Vec2 seen{direction.x, direction.y};
    const Vec3 outside{dot(exit->across, seen), dot(exit->along, seen), direction.z};
    const auto way = way_refracted_into(optics.medium(), exit->plane, outside);
    if (!way)
        return std::nullopt;
    const Vec2 film_point = from - exit->beside - way->x * exit->across - way->y * exit->along;
    if (is_lenticular(optics)) {
        // beam_ray gives no ray where a film point's light has two ways to the slit.
        const Slit& slit = optics.slit();
        const Vec2 foot = film_point + way->x * exit->across;
        if (!reaches_slit(slit, optics.medium(), foot, way->x, signed_height(slit, point.slit),
                          exit->plane))
            return std::nullopt;
    }
    if (!std::isfinite(film_point.x) || !std::isfinite(film_point.y))
        return std::nullopt;
    return film_point;
}

} // namespace integral
