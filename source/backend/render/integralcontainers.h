// SPDX-License-Identifier: AGPL-3.0-or-later
// Which objects a camera ray of an integral camera can start inside of.
#ifndef POVRAY_BACKEND_INTEGRALCONTAINERS_H
#define POVRAY_BACKEND_INTEGRALCONTAINERS_H

#include <vector>

#include "backend/frame.h"
#include "integral/optics/camera.h"

namespace pov
{

/// Whether any of a scene's objects may contain the start of a camera ray, which lies on the
/// capture aperture. No means no: then the search of each ray's containers can be left out.
bool May_Start_Inside(const integral::IntegralCamera& camera, const std::vector<ObjectPtr>& objects,
                      TraceThreadData *thread);

}

#endif
