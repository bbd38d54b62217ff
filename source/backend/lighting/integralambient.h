// SPDX-License-Identifier: AGPL-3.0-or-later
// What may take part when radiosity looks up the ambient light of a place, which is the weighted
// mean of what gathered points around it tell.
#ifndef POVRAY_BACKEND_INTEGRALAMBIENT_H
#define POVRAY_BACKEND_INTEGRALAMBIENT_H

#include "backend/frame.h"

namespace pov
{

class IntegralAmbient
{
public:
    virtual ~IntegralAmbient() {}

    /// Whether the ambient light of a place is known. Sets `light` and `quality`, the sum of the
    /// points' weights, if it is. `important`: the light is needed as exactly as the scene says.
    virtual bool Find(const Vector3d& place, const Vector3d& normal, bool important,
                      RGBColour& light, double& quality)
    {
        return false;
    }

    /// If it is not, a lookup begins,
    virtual void Begin() {}

    /// meets points with their light, as that is expected at the place, `pretraced` ones before the
    /// frame was rendered, each of them used within `radius` (scene units) around it,
    virtual void Add(const RGBColour& light, double weight, bool pretraced, double radius) {}

    /// and ends with their mean.
    virtual void End(RGBColour& mean) {}

    /// Tells of the last place what light and quality are used for it. `wanted`: the quality from
    /// which on no more points are gathered beforehand.
    virtual void Keep(const RGBColour& light, double quality, double wanted) {}
};

}

#endif
