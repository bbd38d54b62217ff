// SPDX-License-Identifier: AGPL-3.0-or-later
// Several views as one picture.
#ifndef INTEGRAL_REPLAY_ARRANGE_H
#define INTEGRAL_REPLAY_ARRANGE_H

#include "integral/replay/replay.h"

#include <vector>

namespace integral {

/// How wide and high the capture aperture is, seen from `distance` mm: mm. No wider than what fills
/// a lens on the axis (or, where nothing does, than twice the distance).
Vec2 viewing_zone(const FrameMetadata& metadata, double distance);

/// Eyes `separation` mm apart, left and right of `middle`.
std::vector<Eye> eye_pair(Eye middle, double separation);

/// columns x rows eyes, row by row from the top left, at the middles of as many equal parts of a
/// rectangle about `middle`, the zone.
std::vector<Eye> eye_grid(Eye middle, int columns, int rows, Vec2 zone);

/// How an eye moves.
enum class EyePath {
    turntable, ///< the sheet turns about its upright middle: an arc, from the left to the right;
               ///< span in degrees, < 180
    sweep,     ///< past the sheet, from the left to the right; span in mm
    circle,    ///< around the middle, in the zone's shape, from the left upwards; span: its longer
               ///< axis, mm
    dolly,     ///< towards the sheet; span: the first distance by the last, >= 1
};

/// Where the eye is at `steps` > 0 places evenly along a path through (circle: around) `middle`:
/// dolly in equal ratios. A circle's last place is a step before its first. Without a span: as far
/// as the viewing zone is wide; circle 0.8 of that; dolly 4.
std::vector<Eye> eye_path(EyePath path, Eye middle, Vec2 zone, std::optional<double> span,
                          int steps);

/// What each of several eyes sees: `view` in its place. Empty: `progress` stopped it.
std::optional<std::vector<Image>> replay_each(const Frame& frame, View view,
                                              const std::vector<Eye>& eyes, int threads = 0,
                                              const Progress& progress = {});

/// A stereo pair for red-cyan glasses: red of the left picture, green and blue of the right; the
/// mean alpha. In the encoded values, as such glasses are used with screens and prints. Throws
/// std::invalid_argument where they differ in size or form.
Image anaglyph(const Image& left, const Image& right);

} // namespace integral

#endif
