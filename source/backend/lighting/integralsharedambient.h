// SPDX-License-Identifier: AGPL-3.0-or-later
// Shares radiosity's ambient light between rays of different lenses. It changes slowly, but to look
// it up takes up to two fifths of a frame's time. Many beams meet the same small cell of a surface,
// so the light that a cell's first ray looks up is taken for all its rays. A cell covers about half
// of a beam's area; all of its normals are nearly alike. It is divided where the light is the mean
// of points each of which counts within less than about the cell's size only: in corners, for
// example.
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
