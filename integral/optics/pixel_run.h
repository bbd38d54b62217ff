// SPDX-License-Identifier: AGPL-3.0-or-later
// Computes the lines of sight of several neighbouring pixels side by side.
#ifndef INTEGRAL_OPTICS_PIXEL_RUN_H
#define INTEGRAL_OPTICS_PIXEL_RUN_H

#include "integral/optics/camera.h"

namespace integral {

/// The pole rays of run_length pixels of a row, from the left.
struct PixelRun {
    RayRun<MappedPoint> mapped; ///< of the pixels' centres
    RayRun<SightLine> lines;    ///< of the imaged pixels only
};

/// `centre`: of the first pixel, in pixels from the film's top left corner. Results equal
/// SheetOptics::map and sight_line bit for bit.
void map_pixel_run(const IntegralCamera& camera, Vec2 centre, PixelRun& run);

} // namespace integral

#endif
