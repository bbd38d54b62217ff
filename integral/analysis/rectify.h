// SPDX-License-Identifier: AGPL-3.0-or-later
// Resamples a scan to the pixels of a film.
#ifndef INTEGRAL_ANALYSIS_RECTIFY_H
#define INTEGRAL_ANALYSIS_RECTIFY_H

#include "integral/analysis/scan_colour.h"
#include "integral/analysis/scan_map.h"
#include "integral/base/parallel.h"
#include "integral/frame/frame.h"

namespace integral {

/// The smallest film of this pixel pitch (mm), centred on the sheet, that holds the whole scan.
/// Width and height are odd or even as in `like` (0 by 0: even), so that the pixels of both films
/// lie in the same places.
Film film_of_scan(const ScanMap& map, int scan_width, int scan_height, Vec2 pixel_pitch,
                  const Film& like);

/// The film to make of a scan: `requested`, cut to the part that the scan covers, unless
/// `of_that_size`. Throws std::invalid_argument for more than 65500 pixels across or down.
Film film_to_make(const Film& requested, bool of_that_size, const ScanMap& map, const Image& scan);

/// Resamples the scan to the film's pixels: each is the scan around its centre, weighted by
/// Lanczos's kernel of three lobes, in linear light, and multiplied by the gain of `light`. If the
/// scan is finer than the film, the kernel is wider by the ratio of their pixels. Pixels whose
/// centre is outside the scan are black. 16 bits, sRGB. Returns nothing if `progress` stopped it.
std::optional<Image> rectified(const Image& scan, const ScanMap& map, const Film& film,
                               const ScanLight& light, int threads, const Progress& progress = {});

} // namespace integral

#endif
