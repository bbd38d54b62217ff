// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests before a render whether the capture aperture of an integral camera reaches below the ground
// or into things, and measures the distances of the surfaces that its rays meet.
#ifndef POVRAY_BACKEND_INTEGRALPROBES_H
#define POVRAY_BACKEND_INTEGRALPROBES_H

#include <vector>

#include "backend/frame.h"
#include "integral/optics/camera.h"

namespace pov
{

class SceneData;

/// Whether the camera sees an object as a surface. Objects without an image and containers of media
/// are no surfaces.
bool Is_Integral_Surface(const ObjectBase *object);

/// Obstruction of the aperture: camera rays that start behind a surface, as seen from the eye in the
/// aperture's middle. Only rays of some of the film's points are tested.
struct ApertureObstruction
{
    double blocked_share = 0; ///< fraction of rays, 0 to 1, that start behind a surface
    double clear = 1;  ///< fraction of the aperture's width and height, about its middle, without
                       ///< such rays, 0 to 1
};

/// Looks along straight lines from the eye to at most 128 rays' starts, for at most 20 ms of
/// processor time. Objects that the camera does not see and containers of media do not count. Finds
/// nothing with depth_range, projection_lens or pseudoscopic, whose rays start nearer to the sheet.
ApertureObstruction Probe_Integral_Starts(const integral::IntegralCamera& camera, const SceneData& scene,
                                     TraceThreadData *thread);

/// Returns the distances from the scene's eye plane, in scene units, of the first surfaces that the
/// scene's eye sees at points spread over the picture; infinite where there is none. There are 200
/// to 2000 points: fewer in scenes with very many objects; above 200, at most one in fifty pixels.
/// Objects that the camera does not see and containers of media do not count. Rounded to floats, as
/// depth frames contain them, so that a report on a depth frame chooses the same fit as the
/// renderer. Pass the print's camera, not a draft's: then both have the same distances.
std::vector<double> Probe_Integral_Depths(const integral::IntegralCamera& camera,
                                          const SceneData& scene, TraceThreadData *thread);

}

#endif
