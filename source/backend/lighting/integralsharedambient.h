// SPDX-License-Identifier: AGPL-3.0-or-later
// Shares radiosity's ambient light between rays of different lenses. To look it up takes POV-Ray
// longer than all else that a ray does in many scenes, and it changes slowly: many beams meet the
// same small cell of a surface. So the light of a cell's first ray is taken for all its rays. A
// cell is a part of half a beam's area, with about the same normal. It is divided where the points
// whose mean the light is are used within less than about its size: in corners, for example.
#ifndef POVRAY_BACKEND_INTEGRALSHAREDAMBIENT_H
#define POVRAY_BACKEND_INTEGRALSHAREDAMBIENT_H

#include <cstdint>

#include "backend/frame.h"
#include "backend/lighting/integralambient.h"
#include "backend/render/integralshadingcache.h"

namespace pov
{

struct IntegralTally;

/// One thread's use of the cells.
class IntegralSharedAmbient : public IntegralAmbient
{
public:
    /// The approximate number of cells in a beam, and their number in the table for each of the
    /// frame's pixels.
    static constexpr double cells_in_beam = 2, cells_a_pixel = 2;

    /// `cells`: a table for nothing else.
    IntegralSharedAmbient(IntegralShadingCache& cells, IntegralTally& tally)
        : cells(cells), tally(tally)
    {
    }

    virtual bool Find(const Vector3d& place, const Vector3d& normal, bool important,
                      RGBColour& light, double& quality);
    virtual void Begin();
    virtual void Add(const RGBColour& light, double weight, bool pretraced, double radius);
    virtual void Keep(const RGBColour& light, double quality, double wanted);

private:
    IntegralShadingCache& cells;
    IntegralTally& tally;
    std::uint64_t key = 0; ///< of the cell whose light is not known yet; 0: there is none
    std::size_t slot = 0;
    double size = 0;         ///< of that cell, scene units
    double least_radius = 0; ///< of the points that were met
};

}

#endif
