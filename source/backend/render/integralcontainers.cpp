// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/render/integralcontainers.h"
#include "backend/scene/objects.h"
#include "backend/shape/planes.h"

#include <algorithm>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

bool May_Start_Inside(const integral::IntegralCamera& camera, const std::vector<ObjectPtr>& objects,
                      TraceThreadData *thread)
{
    if (camera.depth_range)
        return true; // rays start before the sheet, all over it

    // the aperture's corners, a little outwards as its edge belongs to it
    const integral::Aperture& aperture = camera.optics.aperture();
    integral::Vec3 corners[4];
    for (int k = 0; k < 4; k++)
        corners[k] = integral::scene_from_sheet(camera.placement, {(k & 1 ? 0.5001 : -0.5001) * aperture.width,
                                                                   (k & 2 ? 0.5001 : -0.5001) * aperture.height,
                                                                   -aperture.distance});
    const auto least = [&](double integral::Vec3::*axis) {
        return std::min(std::min(corners[0].*axis, corners[1].*axis), std::min(corners[2].*axis, corners[3].*axis));
    };
    const auto most = [&](double integral::Vec3::*axis) {
        return std::max(std::max(corners[0].*axis, corners[1].*axis), std::max(corners[2].*axis, corners[3].*axis));
    };
    const double low[3] = {least(&integral::Vec3::x), least(&integral::Vec3::y), least(&integral::Vec3::z)};
    const double high[3] = {most(&integral::Vec3::x), most(&integral::Vec3::y), most(&integral::Vec3::z)};

    for (const ObjectPtr object : objects)
    {
        if (object->interior == NULL)
            continue;
        bool meets = true;
        for (int axis = X; axis <= Z; axis++)
        {
            const double begin = object->BBox.Lower_Left[axis], length = object->BBox.Lengths[axis];
            const double slack = 1e-6 * (std::fabs(begin) + length);
            meets = meets && begin - slack <= high[axis] && begin + length + slack >= low[axis];
        }
        // a plane's outside is convex: with the four corners out there, all of the aperture is
        if (meets && dynamic_cast<const Plane *>(object) != NULL && object->Clip.empty())
        {
            meets = false;
            for (const integral::Vec3& corner : corners)
            {
                const VECTOR point = {corner.x, corner.y, corner.z};
                meets = meets || object->Inside(point, thread);
            }
        }
        if (meets)
            return true;
    }
    return false;
}

}
