// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests whether a point is inside all parts of an intersection or difference, simple parts first.
#ifndef POVRAY_BACKEND_INSIDEALL_H
#define POVRAY_BACKEND_INSIDEALL_H

#include <vector>

#include "backend/lighting/point.h"
#include "backend/scene/objects.h"

namespace pov
{

/// Whether a point is inside each of `parts` except `but` (NULL: no exception). Compound parts are
/// tested last because they take longest, and most points are outside a simple part. A light counts
/// as a part only if it has a looks_like.
inline bool Inside_All(const std::vector<ObjectPtr>& parts, const ObjectBase *but,
                       const VECTOR point, TraceThreadData *thread)
{
    bool compounds = false;
    for (const ObjectPtr part : parts)
        if (part->Type & IS_COMPOUND_OBJECT)
            compounds = true;
        else if (part != but && !Inside_Object(point, part, thread))
            return false;
    if (!compounds)
        return true;
    for (const ObjectPtr part : parts)
    {
        if (!(part->Type & IS_COMPOUND_OBJECT) || part == but)
            continue;
        const bool asked = !(part->Type & LIGHT_SOURCE_OBJECT) ||
                           !static_cast<const LightSource *>(part)->children.empty();
        if (asked && !Inside_Object(point, part, thread))
            return false;
    }
    return true;
}

}

#endif
