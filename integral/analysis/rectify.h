// SPDX-License-Identifier: AGPL-3.0-or-later
// A scan resampled to a film's own pixels.
#ifndef INTEGRAL_ANALYSIS_RECTIFY_H
#define INTEGRAL_ANALYSIS_RECTIFY_H

#include "integral/analysis/scan_colour.h"
#include "integral/analysis/scan_map.h"
#include "integral/base/parallel.h"
#include "integral/lightfield/frame.h"

namespace integral {

/// The smallest film of these pixels, centred on the sheet, that holds all of the scan. Width and
/// height odd or even as `like`'s, so that their pixels lie on the same places; `like` of 0 by 0:
/// even.
Film film_of_scan(const ScanMap& map, int scan_width, int scan_height, Vec2 pixel_pitch,
                  const Film& like);

/// The film's pixels, each from the scan around its centre by Lanczos's kernel of three lobes, in
/// linear light and multiplied by `light`; where the scan is finer than the film the kernel is so
/// much wider. Black where a centre is outside the scan. 16 bits, sRGB. Nothing: `progress` stopped
/// it.
std::optional<Image> rectified(const Image& scan, const ScanMap& map, const Film& film,
                               const ScanLight& light, int threads, const Progress& progress = {});

} // namespace integral

#endif
