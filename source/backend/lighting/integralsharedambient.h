// SPDX-License-Identifier: AGPL-3.0-or-later
// Shares radiosity's ambient light between rays of different lenses. The light changes slowly, but looking it
// up takes up to two fifths of a frame's time. Many beams meet the same small cell of a surface, so the light
// that a cell's first ray looks up is used for all its rays. A cell covers about half of a beam's area, and
// its normals are nearly equal. A cell is divided if a point of its lookup may be used only within a radius
// smaller than about the cell's size, as in corners.
#ifndef POVRAY_BACKEND_INTEGRALSHAREDAMBIENT_H
#define POVRAY_BACKEND_INTEGRALSHAREDAMBIENT_H

#include <cstdint>

#include "backend/frame.h"
#include "backend/lighting/integralambient.h"
#include "backend/render/integralshadingcache.h"

namespace pov
{

struct ThreadCounters;

/// One thread's use of the cells.
class IntegralSharedAmbient : public IntegralAmbient
{
public:
    /// The approximate number of cells in a beam, and the number of cells in the table for each pixel of the
    /// frame.
    static constexpr double cells_in_beam = 2, cells_a_pixel = 2;

    /// `cells`: a table that is used for nothing else.
    IntegralSharedAmbient(IntegralShadingCache& cells, ThreadCounters& tally)
        : cells(cells), tally(tally)
    {
    }

    virtual bool Find(const Vector3d& place, const Vector3d& normal, bool important,
                      RGBColour& light, double& quality);
    virtual void Begin();
    virtual void Add(const RGBColour& light, double weight, bool pretraced, double radius);
    virtual void Keep(const RGBColour& light, double quality, double requested);

private:
    IntegralShadingCache& cells;
    ThreadCounters& tally;
    std::uint64_t key = 0; ///< of the cell whose light is not known yet; 0: there is none
    std::size_t slot = 0;
    double size = 0;         ///< of that cell, scene units
    double least_radius = 0; ///< smallest radius of the lookup's points
};

}

#endif
