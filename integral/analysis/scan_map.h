// SPDX-License-Identifier: AGPL-3.0-or-later
// Maps between a print and its scan.
#ifndef INTEGRAL_ANALYSIS_SCAN_MAP_H
#define INTEGRAL_ANALYSIS_SCAN_MAP_H

#include "integral/optics/vec.h"

namespace integral {

/// Place and rotation of a film in a scan. Scan pixels are continuous: the origin is the
/// top left corner of the top left pixel, and y points downwards.
struct ScanMap {
    Vec2 middle;         ///< scan pixel of the sheet's centre
    Vec2 scale{1, 1};    ///< scan pixels per mm, along the scan's own x and y; > 0
    double rotation = 0; ///< radians by which the print is turned, anticlockwise as the viewer sees
                         ///< it
};

/// The scan pixel of a film point (mm, sheet frame).
inline Vec2 scan_from_film(const ScanMap& map, Vec2 point)
{
    const double c = std::cos(map.rotation), s = std::sin(map.rotation);
    return {map.middle.x + map.scale.x * (c * point.x - s * point.y),
            map.middle.y - map.scale.y * (s * point.x + c * point.y)};
}

/// Inverse of scan_from_film.
inline Vec2 film_from_scan(const ScanMap& map, Vec2 pixel)
{
    const double c = std::cos(map.rotation), s = std::sin(map.rotation);
    const double x = (pixel.x - map.middle.x) / map.scale.x,
                 y = (map.middle.y - pixel.y) / map.scale.y;
    return {c * x + s * y, -s * x + c * y};
}

/// The same place in a scan whose pixels are `factor` times as wide.
inline ScanMap in_larger_pixels(const ScanMap& map, double factor)
{
    return {(1 / factor) * map.middle, (1 / factor) * map.scale, map.rotation};
}

} // namespace integral

#endif
