// SPDX-License-Identifier: AGPL-3.0-or-later
// Resamples a scan to the pixels of a film.
#ifndef INTEGRAL_ANALYSIS_RECTIFY_H
#define INTEGRAL_ANALYSIS_RECTIFY_H

#include "integral/analysis/scan_colour.h"
#include "integral/analysis/scan_map.h"
#include "integral/base/parallel.h"
#include "integral/lightfield/frame.h"

namespace integral {

/// The smallest film of this pixel pitch (mm), centred on the sheet, that holds the whole scan.
/// Width and height are odd or even as those of `like` are, so that the pixels of both lie in the
/// same places; even if `like` is 0 by 0.
Film film_of_scan(const ScanMap& map, int scan_width, int scan_height, Vec2 pixel_pitch,
                  const Film& like);

/// The film to make of a scan: `wanted`, cut to what the scan holds unless it is to be
/// `of_that_size`. Throws std::invalid_argument for more than 65500 pixels across or down.
Film film_to_make(const Film& wanted, bool of_that_size, const ScanMap& map, const Image& scan);

/// The film's pixels: each is the scan around its centre, weighted by Lanczos's kernel of three
/// lobes, in linear light, and multiplied by `light`. If the scan is finer than the film, the
/// kernel is wider by that factor. Pixels whose centre is outside the scan are black. 16 bits,
/// sRGB. Nothing: `progress` stopped it.
std::optional<Image> rectified(const Image& scan, const ScanMap& map, const Film& film,
                               const ScanLight& light, int threads, const Progress& progress = {});

} // namespace integral

#endif
