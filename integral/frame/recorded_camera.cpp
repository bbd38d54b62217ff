// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/frame/recorded_camera.h"

#include <stdexcept>

namespace integral {
namespace {

/// Places the sheet frame on itself.
Placement in_sheet_frame()
{
    Placement placement;
    placement.x = {1, 0, 0};
    placement.y = {0, 1, 0};
    placement.z = {0, 0, 1};
    placement.right_angled = true;
    return placement;
}

} // namespace

IntegralCamera recorded_camera(const FrameMetadata& m, CameraSpace space)
{
    if (m.projection)
        throw std::invalid_argument("frames for a projection lens are not supported here; use "
                                    "integral replay");
    if (space == CameraSpace::scene && !m.placement)
        throw std::invalid_argument("the frame's geometry lacks the sheet's place in a scene; use "
                                    "the sheet's space, in mm");
    const RenderRecord render = m.render.value_or(RenderRecord());
    IntegralCamera camera{SheetOptics(m.sheet, m.aperture, render.model), m.film, in_sheet_frame(),
                          render.mapping, std::nullopt};
    camera.pseudoscopic = render.pseudoscopic;
    if (space == CameraSpace::scene) {
        camera.placement = *m.placement;
        camera.parallax = m.parallax;
        camera.relief = relief_of(m);
    }
    return camera;
}

} // namespace integral
