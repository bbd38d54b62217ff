// SPDX-License-Identifier: AGPL-3.0-or-later
// Chooses the eyes of several views, replays them, and combines pairs to anaglyphs.
#ifndef INTEGRAL_REPLAY_ARRANGE_H
#define INTEGRAL_REPLAY_ARRANGE_H

#include "integral/replay/replay.h"

#include <vector>

namespace integral {

/// Width and height, in mm, of the viewing zone at `distance` mm: the capture aperture's, scaled to
/// that distance. Each side is limited to the aperture that just fills the lens on the axis or, if
/// no aperture fills the lens, to twice the distance.
Vec2 viewing_zone(const FrameMetadata& metadata, double distance);

/// Two eyes `separation` mm apart, left and right of `middle`, as a viewer's are, even for lenses
/// that lie across (horizontal cylinders).
std::vector<Eye> eye_pair(Eye middle, double separation);

/// columns x rows eyes, row by row from the top left, at the centres of equal parts of the
/// rectangle `zone` (width and height in mm) about `middle`.
std::vector<Eye> eye_grid(Eye middle, int columns, int rows, Vec2 zone);

/// The eyes of a contact sheet of columns x rows pictures: eye_grid over the viewing zone. For a
/// single row and lenses that lie across, the eyes are above each other, the lowest first; eyes
/// side by side would all see the same.
std::vector<Eye> contact_sheet_eyes(const FrameMetadata& metadata, Eye middle, int columns,
                                    int rows);

/// The path of a moving eye, for upright lenses. If the lenses lie across, turntable, sweep and
/// sway go upwards instead of to the right, and the turntable's axis is horizontal.
enum class EyePath {
    turntable, ///< an arc about the sheet's vertical axis, from left to right, as if the sheet
               ///< turned; span in degrees, < 180
    sweep,     ///< parallel to the sheet, from left to right; span in mm
    sway,      ///< parallel to the sheet, from the middle to the right, to the left and back,
               ///< slowly at the ends; span in mm
    circle,    ///< an ellipse about `middle` with the zone's aspect, from the left upwards; span:
               ///< its longer axis, mm
    dolly,     ///< towards the sheet; span: ratio of the first distance to the last, >= 1
};

/// `steps` > 0 positions of the eye at equal steps (dolly: equal ratios) along a path through
/// `middle` (circle: around `middle`). For circle and sway, the last position is one step before
/// the first. Default span: the width of the viewing zone (its height if `upwards`); for a circle
/// and sway 0.8 of the zone; for dolly 4.
std::vector<Eye> eye_path(EyePath path, Eye middle, Vec2 zone, std::optional<double> span,
                          int steps, bool upwards = false);

/// Replays `view` from each of several eyes. Returns nothing if `progress` stopped the work.
std::optional<std::vector<Image>> replay_each(const Frame& frame, View view,
                                              const std::vector<Eye>& eyes, int threads = 0,
                                              const Progress& progress = {});

/// An anaglyph for red-cyan glasses: red from the left picture, green and blue from the right, and
/// the mean alpha. Combines encoded values, since the glasses are used with screens and prints.
/// Throws std::invalid_argument if the pictures differ in size or form.
Image anaglyph(const Image& left, const Image& right);

} // namespace integral

#endif
