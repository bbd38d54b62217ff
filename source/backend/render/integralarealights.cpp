// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/render/integralarealights.h"
#include "backend/lighting/point.h"
#include "backend/render/ray.h"
#include "backend/render/trace.h"
#include "backend/scene/objects.h"
#include "backend/scene/scene.h"
#include "integral/sampling/sample_points.h"

#include <algorithm>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

bool IntegralAreaLights::Of_Use(const SceneData& scene)
{
    const auto is_divided = [](const LightSource *light)
    { return light->Area_Light && light->Adaptive_Level > 0; };
    const auto any = [&](const vector<LightSource *>& lights)
    { return std::any_of(lights.begin(), lights.end(), is_divided); };
    return any(scene.lightSources) || any(scene.lightGroupLightSources);
}

void IntegralAreaLights::Begin_Shadow()
{
    const std::uint64_t key = integral::random_bits(sample_key, ++shadows);
    const auto point = integral::scrambled_point(
        integral::point_seeds(key), integral::shuffled_index(std::uint32_t(key), sample_index));
    u = point[0];
    v = point[1];
}

IntegralAreaLights::Quarter IntegralAreaLights::Choose()
{
    const auto halve = [](double& x)
    {
        const bool second = x >= 0.5;
        x = 2 * x - second;
        return second;
    };
    return {halve(u), halve(v)};
}

namespace
{

/// A part of an area light's grid of points: points u1 to u2 along one side, v1 to v2 along the
/// other.
struct LightPart
{
    int u1, v1, u2, v2;

    bool Is_Divisible() const { return u2 - u1 > 1 || v2 - v1 > 1; }

    /// Neighbouring quarters share the row of points in the middle, if there is one.
    LightPart Divided(IntegralAreaLights::Quarter at) const
    {
        return {at.u ? (u1 + u2 + 1) / 2 : u1, at.v ? (v1 + v2 + 1) / 2 : v1,
                at.u ? u2 : (u1 + u2) / 2, at.v ? v2 : (v1 + v2) / 2};
    }

    LightPart Corner(IntegralAreaLights::Quarter at) const
    {
        const int u = at.u ? u2 : u1, v = at.v ? v2 : v1;
        return {u, v, u, v};
    }
};

/// The light of an area light's parts at a point of a surface. `See(const LightPart&, int level)`
/// returns the light of a part that has been divided `level` times, as POV-Ray computes it.
template <class See> class SampledAreaLight
{
public:
    SampledAreaLight(int even_levels, IntegralAreaLights& choice, See see)
        : even_levels(even_levels), choice(choice), see(see)
    {
    }

    /// Returns the light of the whole area light.
    RGBColour All(const LightPart& light)
    {
        if (even_levels < 1 || !light.Is_Divisible())
            return see(light, 0);
        const IntegralAreaLights::Quarter one = choice.Choose();
        return (Part(light.Divided(one), 1) + Part(light.Divided(one.Opposite()), 1)) * 0.5;
    }

private:
    RGBColour Part(const LightPart& part, int level)
    {
        if (!part.Is_Divisible())
            return see(part.Corner(choice.Choose()), level);
        return level < even_levels ? Part(part.Divided(choice.Choose()), level + 1)
                                   : see(part, level);
    }

    int even_levels; ///< number of divisions that POV-Ray always makes
    IntegralAreaLights& choice;
    See see;
};

}

bool Trace::SampleLight(const LightSource& light, double& depth, Ray& to_light,
                        const Vector3d& point, RGBColour& colour, const Vector3d& axis1,
                        const Vector3d& axis2, TraceTicket& ticket)
{
    if (integralAreaLights == NULL || !integralAreaLights->Samples())
        return false;
    const auto see = [&](const LightPart& part, int level)
    {
        RGBColour seen(colour);
        TraceAreaLightSubsetShadowRay(light, depth, to_light, point, seen, part.u1, part.v1,
                                      part.u2, part.v2, level, axis1, axis2, ticket);
        return seen;
    };
    integralAreaLights->Begin_Shadow();
    colour = SampledAreaLight(light.Adaptive_Level, *integralAreaLights, see)
                 .All({0, 0, light.Area_Size1 - 1, light.Area_Size2 - 1});
    return true;
}

}
