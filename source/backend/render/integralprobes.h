// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds out before a render whether the capture aperture of an integral camera reaches below the
// ground or into things, and how far from the sheet the surfaces are that its rays meet.
#ifndef POVRAY_BACKEND_INTEGRALPROBES_H
#define POVRAY_BACKEND_INTEGRALPROBES_H

#include <vector>

#include "backend/frame.h"
#include "integral/optics/camera.h"

namespace pov
{

class SceneData;

/// Whether the camera sees an object as a surface: not one without an image, nor a container of
/// media.
bool Is_Integral_Surface(const ObjectBase *object);

/// Where the camera rays of a sample of the film's points start, seen from the eye, which is the
/// middle of the aperture.
struct IntegralStarts
{
    double parted = 0; ///< the share of rays, 0 to 1, that start beyond a surface from the eye
    double clear = 1;  ///< how much of the aperture's width and height, about its middle, has no
                       ///< such ray, 0 to 1
};

/// Looks along straight lines from the eye to at most 128 rays' starts, for at most 20 ms of
/// processor time. Objects that the camera does not see and containers of media do not count. With
/// depth_range, projection_lens or pseudoscopic, whose rays start nearer to the sheet, nothing is
/// found.
IntegralStarts Probe_Integral_Starts(const integral::IntegralCamera& camera, const SceneData& scene,
                                     TraceThreadData *thread);

/// The distances from the scene's eye plane, in scene units, of the first surfaces behind points
/// spread over the picture, seen from the scene's eye; infinite where there is none. 200 to 2000
/// points: fewer among very many objects, at most one in fifty pixels above 200. Objects that the
/// camera does not see and containers of media do not count. Rounded to floats, as depth frames
/// contain them, so that a report on a depth frame chooses the same fit as the renderer. Give the
/// camera of the print, not of a draft of it: then both have the same distances.
std::vector<double> Probe_Integral_Depths(const integral::IntegralCamera& camera,
                                          const SceneData& scene, TraceThreadData *thread);

}

#endif
