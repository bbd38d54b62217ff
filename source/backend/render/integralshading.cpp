// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/render/integralshading.h"
#include "backend/interior/interior.h"
#include "backend/render/ray.h"
#include "backend/render/trace.h"
#include "backend/lighting/point.h"
#include "backend/scene/integralcamera.h"
#include "backend/scene/objects.h"
#include "backend/scene/scene.h"
#include "integral/sampling/pixel_sampler.h"

#include <cmath>
#include <cstring>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

namespace
{

constexpr std::uint64_t word_step = 0x9e3779b97f4a7c15u; // an odd number with irregular bits
constexpr int height_steps = 4;                          // height of a patch, in patch sizes

double Random(std::uint64_t bits) { return double(bits >> 11) * 0x1p-53; }

/// Turns an object's normal to the direction that POV-Ray's shading uses.
void Turn_Out(VECTOR normal, const ObjectBase *object)
{
    if (Test_Flag(object, INVERTED_FLAG))
        for (int k = 0; k < 3; k++)
            normal[k] = -normal[k];
}

/// A hash of an object that does not depend on its address and is rarely the same for another
/// object.
std::uint64_t Number_Of(const ObjectBase& object)
{
    std::uint64_t number = object.Type;
    for (int k = 0; k < 3; k++)
    {
        const float corner = object.BBox.Lower_Left[k], size = object.BBox.Lengths[k];
        std::uint32_t bits[2];
        std::memcpy(&bits[0], &corner, sizeof corner);
        std::memcpy(&bits[1], &size, sizeof size);
        number = (number * word_step + bits[0]) * word_step + bits[1];
    }
    return number;
}

double Against(const VECTOR normal, const Ray& ray)
{
    return normal[X] * ray.Direction[X] + normal[Y] * ray.Direction[Y] +
           normal[Z] * ray.Direction[Z];
}

}

IntegralCachedShading::IntegralCachedShading(IntegralShadingCache& patches, ThreadCounters& tally,
                                             TraceThreadData *thread)
    : patches(patches), tally(tally), thread(thread)
{
}

bool IntegralCachedShading::Pays(const SceneData& scene)
{
    bool area_light = false;
    for (std::size_t k = 0; k < scene.lightSources.size(); k++)
    {
        const LightSource& light = *scene.lightSources[k];
        area_light = area_light || (light.Area_Light && light.Area_Size1 * light.Area_Size2 > 1);
    }
    return scene.radiositySettings.radiosityEnabled || area_light;
}

void IntegralCachedShading::Count(bool worked_out)
{
    tally.shared_shadings.Add(1);
    tally.patch_shadings.Add(worked_out);
}

bool IntegralCachedShading::May_Share(const Ray& ray)
{
    if (ray.IsShadowTestRay() || ray.IsPhotonRay() || ray.IsRadiosityRay() || ray.IsPretraceRay() ||
        ray.IsMonochromaticRay() || ray.IsSubsurfaceRay())
        return false;
    const RayInteriorVector& interiors = ray.GetInteriors();
    for (RayInteriorVector::const_iterator i(interiors.begin()); i != interiors.end(); i++)
        if (!(*i)->media.empty())
            return false;
    return true;
}

/// Returns whether the ray meets the object's inside, and sets `normal` as shading uses it.
bool IntegralCachedShading::Side_Seen(Intersection& isect, const Ray& ray, VECTOR normal) const
{
    isect.Object->Normal(normal, &isect, thread);
    Turn_Out(normal, isect.Object);
    return Against(normal, ray) > 0;
}

/// Finds the patch of an intersection. `coarser`: levels by which it is larger than one for colours.
bool IntegralCachedShading::Locate(const Intersection& isect, const VECTOR normal, bool inside,
                                   int coarser, Place& place) const
{
    place.inside = inside;
    place.axis = std::fabs(normal[X]) >= std::fabs(normal[Y]) ? X : Y;
    if (std::fabs(normal[Z]) > std::fabs(normal[place.axis]))
        place.axis = Z;
    place.positive = (normal[place.axis] > 0) != place.inside;
    const int level = patches.Level(isect.IPoint) + coarser;
    place.size = IntegralShadingCache::Size(level);
    std::uint64_t spot = level * 16 + place.axis * 4 + place.positive * 2 + place.inside,
                  row = spot;
    place.column = 0;
    for (int k = 0; k < 3; k++)
    {
        const double side = k == place.axis ? height_steps * place.size : place.size;
        const double index = std::floor(isect.IPoint[k] / side);
        if (!(std::fabs(index) < 1e15))
            return false;
        place.centre[k] = (index + 0.5) * side;
        const std::int64_t cell = std::int64_t(index);
        spot = spot * word_step + cell;
        row = row * word_step +
              (k == place.axis ? cell : cell >> IntegralShadingCache::square_bits);
        if (k != place.axis)
            place.column = place.column * IntegralShadingCache::square +
                           (cell & (IntegralShadingCache::square - 1));
    }
    place.spot = spot;
    const auto address = [](const void *of)
    { return std::uint64_t(reinterpret_cast<std::uintptr_t>(of)); };
    place.key = integral::random_bits(address(isect.Object) * word_step + address(isect.Csg),
                                      spot) |
                1;
    place.row = integral::random_bits(Number_Of(*isect.Object), row);
    return true;
}

/// Place in the table of source `light`'s light on a patch: not in the row of the patch's colour.
IntegralCachedShading::Place IntegralCachedShading::Of_Light(const Place& place, int light)
{
    Place of_light = place;
    of_light.key = integral::random_bits(place.key, std::uint64_t(light) + 1) | 1;
    of_light.row = integral::random_bits(place.row, std::uint64_t(light) + 1);
    return of_light;
}

float IntegralCachedShading::Height_Of(const Intersection& at, const Place& place)
{
    return float((at.IPoint[place.axis] - place.centre[place.axis]) / place.size);
}

/// Whether an intersection is near the patch's point, and not on another fold of the surface.
bool IntegralCachedShading::On_Patch(const IntegralShadingCache::Patch& patch, const Place& place,
                                     const Intersection& isect)
{
    constexpr float far = 2.5f;
    return std::fabs(Height_Of(isect, place) - patch.note) <= far;
}

/// Finds the patch's point: where a line along the patch's axis, at a random position in the patch,
/// first meets the visible side of the surface. Sets `ray` to that line.
bool IntegralCachedShading::Put(const Place& place, const Intersection& isect, Trace& trace,
                                Ray& ray, Intersection& at) const
{
    const double sign = place.positive ? 1 : -1;
    const double reach = (0.5 * height_steps + 2) * place.size;
    ray.SetFlags(Ray::PrimaryRay);
    for (int k = 0; k < 3; k++)
    {
        ray.Origin[k] = place.centre[k];
        ray.Direction[k] = 0;
    }
    ray.Origin[place.axis] += sign * reach;
    ray.Direction[place.axis] = -sign;
    for (int k = 1; k < 3; k++)
        ray.Origin[(place.axis + k) % 3] += (Random(integral::random_bits(place.spot, k)) - 0.5) *
                                            place.size;
    if (!trace.FindIntersection(isect.Object, at, ray, 2 * reach))
        return false;
    at.Csg = isect.Csg;
    VECTOR normal;
    const bool inside = Side_Seen(at, ray, normal);
    return inside == place.inside && (normal[place.axis] > 0) != inside == place.positive;
}

template <class Look>
bool IntegralCachedShading::Take(const Place& place, const Intersection& isect, Trace& trace,
                                 IntegralShadingCache::Patch& patch, Look look)
{
    const std::size_t slot = patches.Slot(place.row, place.column);
    bool worked_out = false;
    if (!patches.Find(slot, place.key, patch))
    {
        Ray from;
        Intersection at;
        patch.key = place.key;
        patch.note = std::numeric_limits<float>::quiet_NaN();
        if (Put(place, isect, trace, from, at))
        {
            worked_out = true;
            if (look(from, at))
                patch.note = Height_Of(at, place);
        }
        patches.Store(slot, patch);
    }
    if (!On_Patch(patch, place, isect))
        return false;
    Count(worked_out);
    return true;
}

template <class Shade>
bool IntegralCachedShading::Colour_Of(Intersection& isect, const Ray& ray, Trace& trace,
                                      Colour& colour, Shade shade)
{
    if (!May_Share(ray))
        return false;
    VECTOR normal;
    const bool inside = Side_Seen(isect, ray, normal);
    Assign_Vector(isect.INormal, normal); // as ComputeTextureColour does, if it is called
    if (Kind_Of(isect, inside) == own)
    {
        lit.isect = isect;
        lit.located = Locate(isect, normal, inside, patches.Coarser_For_Lights(), lit.place);
        return false;
    }
    Place place;
    if (!Locate(isect, normal, inside, 0, place))
        return false;
    IntegralShadingCache::Patch patch;
    const auto look = [&](const Ray& from, Intersection& at)
    {
        Colour seen;
        seen.clear();
        shade(at, from, seen);
        patch.red = seen.red();
        patch.green = seen.green();
        patch.blue = seen.blue();
        return seen.filter() == 0 && seen.transm() == 0;
    };
    if (!Take(place, isect, trace, patch, look))
        return false;
    colour.red() += patch.red;
    colour.green() += patch.green;
    colour.blue() += patch.blue;
    return true;
}

template <class Test>
bool IntegralCachedShading::Light_Of(int light, const Vector3d& point, const ObjectBase *object,
                                     Trace& trace, RGBColour& colour, Test test)
{
    if (!lit.located || object != lit.isect.Object || point[X] != lit.isect.IPoint[X] ||
        point[Y] != lit.isect.IPoint[Y] || point[Z] != lit.isect.IPoint[Z])
        return false;
    const Place place = Of_Light(lit.place, light);
    IntegralShadingCache::Patch patch;
    const auto look = [&](const Ray&, Intersection& at)
    {
        RGBColour full, left;
        test(Vector3d(at.IPoint), full, left);
        const auto part = [](float whole, float some) { return whole != 0 ? some / whole : 1.0f; };
        patch.red = part(full.red(), left.red());
        patch.green = part(full.green(), left.green());
        patch.blue = part(full.blue(), left.blue());
        return true;
    };
    if (!Take(place, lit.isect, trace, patch, look))
        return false;
    colour *= RGBColour(patch.red, patch.green, patch.blue);
    return true;
}

bool Trace::ComputeCachedTextureColour(Intersection& isect, Colour& colour, const Ray& ray,
                                       TraceTicket& ticket)
{
    const auto shade = [&](Intersection& at, const Ray& from, Colour& seen)
    {
        Forget_Shadow_Casters();
        ComputeTextureColour(at, seen, from, 1.0, false, ticket);
    };
    return integralShading->Colour_Of(isect, ray, *this, colour, shade);
}

bool Trace::ComputeCachedShadow(const LightSource& light, int light_index, const Vector3d& point,
                                ConstObjectPtr object, const Ray& eye, RGBColour& colour,
                                TraceTicket& ticket)
{
    const auto test = [&](const Vector3d& at, RGBColour& full, RGBColour& left)
    {
        double distance = 0;
        Ray to_light(eye);
        ComputeOneLightRay(light, distance, to_light, at, full);
        left = full;
        Forget_Shadow_Casters();
        TraceShadowRay(light, distance, to_light, at, left, ticket);
    };
    return integralShading->Light_Of(light_index, point, object, *this, colour, test);
}

/// Forgets the objects that cast the last shadows, which POV-Ray tests first: a patch must not
/// depend on the ray that was traced before.
void Trace::Forget_Shadow_Casters()
{
    lightSourceLevel1ShadowCache.assign(lightSourceLevel1ShadowCache.size(), NULL);
    lightSourceOtherShadowCache.assign(lightSourceOtherShadowCache.size(), NULL);
}

}
