// SPDX-License-Identifier: AGPL-3.0-or-later
// The calibration files of Looking Glass displays, and the mapping from a subpixel to a view that their makers publish.
#ifndef INTEGRAL_OUTPUT_LOOKING_GLASS_H
#define INTEGRAL_OUTPUT_LOOKING_GLASS_H

#include "integral/optics/subpixels.h"

#include <string>

namespace integral {

/// The fields of a calibration, by the names and in the units that they have in the file (each may be nested: {"value": x}).
struct LookingGlassCalibration {
    std::string version, serial;
    double pitch = 0;             ///< micro-images per inch, across the lenses
    double slope = 0;             ///< height by width of the lenses' lean; negative: to the right going down... as the file has it
    double center = 0;            ///< phase, in micro-images
    double view_cone = 40;        ///< degrees
    double vertical_angle = 0;    ///< degrees
    double dpi = 0;
    int width = 0, height = 0;    ///< screenW, screenH
    bool inverted_views = true;   ///< invView
    bool flip_x = false, flip_y = false, flip_subpixels = false;
    Subpixels cells;              ///< of subpixelCells and CellPatternMode; none: the stripes of the formula
};

/// Throws std::invalid_argument naming the field.
LookingGlassCalibration looking_glass_from_json(const std::string& text);

/// The published mapping: in [0, 1) from the leftmost view to the rightmost, for a colour (0 red, 1 green, 2 blue) of the pixel of
/// a column and a row, counted from the top left of the image that the display is sent.
double view_of_subpixel(const LookingGlassCalibration& calibration, int column, int row, int channel);

} // namespace integral

#endif
