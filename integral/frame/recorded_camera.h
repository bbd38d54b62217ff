// SPDX-License-Identifier: AGPL-3.0-or-later
// The camera that made a frame, from the frame's geometry.
#ifndef INTEGRAL_FRAME_RECORDED_CAMERA_H
#define INTEGRAL_FRAME_RECORDED_CAMERA_H

#include "integral/frame/frame_metadata.h"

namespace integral {

/// The space of a camera's lines of sight.
enum class CameraSpace {
    sheet, ///< the sheet frame as the viewer sees it, mm
    scene  ///< the scene that was rendered, in its units
};

/// The camera of a geometry, with one sample for each pixel. The render record gives model, mapping
/// and pseudoscopic capture; without a record they have their defaults. Throws
/// std::invalid_argument for frames for a projection lens, and for CameraSpace::scene if the
/// geometry lacks the sheet's place in the scene.
IntegralCamera recorded_camera(const FrameMetadata& metadata,
                               CameraSpace space = CameraSpace::sheet);

} // namespace integral

#endif
