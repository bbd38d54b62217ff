// SPDX-License-Identifier: AGPL-3.0-or-later
// Callbacks for radiosity's lookup of the ambient light at a place: the weighted mean of the light at
// gathered points around it.
#ifndef POVRAY_BACKEND_INTEGRALAMBIENT_H
#define POVRAY_BACKEND_INTEGRALAMBIENT_H

#include "backend/frame.h"

namespace pov
{

class IntegralAmbient
{
public:
    virtual ~IntegralAmbient() {}

    /// Returns whether the ambient light of a place is known; if so, sets `light`, and `quality`
    /// to the sum of the points' weights. `important`: the light is needed with the accuracy that
    /// the scene specifies.
    virtual bool Find(const Vector3d& place, const Vector3d& normal, bool important,
                      RGBColour& light, double& quality)
    {
        return false;
    }

    /// Begins a lookup, if the light is not known.
    virtual void Begin() {}

    /// Adds a point to the lookup. `light`: the ambient light at the place, as this point predicts it.
    /// `pretraced`: the point was gathered before the frame was rendered. `radius`: greatest distance from
    /// the point at which it is used, scene units.
    virtual void Add(const RGBColour& light, double weight, bool pretraced, double radius) {}

    /// Ends the lookup with the points' mean, which may be changed.
    virtual void End(RGBColour& mean) {}

    /// Reports the light and quality that are used for the last place. `requested`: the quality at which the
    /// pretrace stops gathering points.
    virtual void Keep(const RGBColour& light, double quality, double requested) {}
};

}

#endif
