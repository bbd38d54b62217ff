// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/lighting/integralsharedambient.h"
#include "backend/scene/integralcamera.h"
#include "integral/sampling/pixel_sampler.h"

#include <algorithm>
#include <cmath>
#include <limits>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

namespace
{

// The maximum of a cell's size, relative to the radius within which points are used; the minimum
// quality of its light, relative to the requested quality; and the step of the components by which
// normals are distinguished. Found by experiment on POV-Ray's sample scenes.
constexpr double most_of_radius = 0.7, least_of_quality = 0.2, step_of_normal = 0.125;

// Maximum number of divisions of a cell, each time into eight.
constexpr int most_divisions = 2;

std::uint64_t Steps(double way, double step) { return std::int64_t(std::floor(way / step)); }

/// The key of the cell with a side of `size` in which a place lies. Never 0.
std::uint64_t Key_Of(const Vector3d& place, const Vector3d& normal, int level, double size)
{
    std::uint64_t key = level;
    for (int k = 0; k < 3; k++)
        key = integral::random_bits(key, Steps(place[k], size) * 64 +
                                             Steps(normal[k] + step_of_normal / 2, step_of_normal));
    return key | 1;
}

}

bool IntegralSharedAmbient::Find(const Vector3d& place, const Vector3d& normal, bool important,
                                 RGBColour& light, double& quality)
{
    key = 0;
    if (!important)
        return false;
    int level = cells.Level(*place);
    for (int divided = 0; divided <= most_divisions; divided++, level -= 2)
    {
        size = IntegralShadingCache::Size(level);
        const std::uint64_t searched = Key_Of(place, normal, level, size);
        slot = cells.Slot(searched / IntegralShadingCache::row_length,
                          searched / 2 % IntegralShadingCache::row_length);
        IntegralShadingCache::Patch cell;
        if (!cells.Find(slot, searched, cell))
        {
            key = searched;
            return false;
        }
        if (std::isnan(cell.note)) // divided
            continue;
        light = RGBColour(cell.red, cell.green, cell.blue);
        quality = cell.note;
        tally.shared_shadings.Add(1);
        return true;
    }
    return false;
}

void IntegralSharedAmbient::Begin() { least_radius = std::numeric_limits<double>::infinity(); }

void IntegralSharedAmbient::Add(const RGBColour&, double, bool, double radius)
{
    least_radius = std::min(least_radius, radius);
}

void IntegralSharedAmbient::Keep(const RGBColour& light, double quality, double requested)
{
    const bool is_kept = quality > least_of_quality * requested;
    if (key == 0 || !is_kept)
        return;
    const bool divides = size > most_of_radius * least_radius;
    cells.Store(slot, {key, light.red(), light.green(), light.blue(),
                       divides ? std::numeric_limits<float>::quiet_NaN() : float(quality)});
    if (!divides)
    {
        tally.shared_shadings.Add(1);
        tally.patch_shadings.Add(1);
    }
    key = 0;
}

}
