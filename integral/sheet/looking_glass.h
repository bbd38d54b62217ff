// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads calibration files of Looking Glass displays, and computes the published mapping from a
// subpixel to a view.
#ifndef INTEGRAL_SHEET_LOOKING_GLASS_H
#define INTEGRAL_SHEET_LOOKING_GLASS_H

#include "integral/base/json.h"
#include "integral/frame/view_grid.h"
#include "integral/optics/subpixels.h"

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace integral {

/// Views across and up, and the size of the whole quilt in pixels.
struct PanelQuilt {
    ViewGrid tiles;
    int width, height;
};

/// The fields of a calibration, in the file's units (visual.json). Every display has its own.
struct LookingGlassCalibration {
    std::string version, serial; ///< configVersion, serial
    double pitch = 0; ///< micro-images per inch, across the lenses: a little fewer than the lenses
                      ///< per inch; > 0
    double slope = 0; ///< of the lenses, height by width: positive if they lean to the left going
                      ///< up; not 0
    double center = 0;         ///< phase of the mapping, in micro-images
    double view_cone = 40;     ///< viewCone: angle from the leftmost view to the rightmost, degrees
    double vertical_angle = 0; ///< verticalAngle, degrees: for cameras, not part of the mapping
    double fringe = 0;         ///< not part of the mapping
    double dpi = 0;            ///< DPI: pixels per inch, both ways
    int width = 0, height = 0; ///< screenW, screenH: pixels
    bool inverted_views = true; ///< invView: passed on, but not part of the mapping; see
                                ///< view_of_subpixel
    bool flip_x = false; ///< flipImageX: the display is seen in a mirror, left and right exchanged,
                         ///< and its image is sent mirrored likewise; see view_of_subpixel
    bool flip_y = false; ///< flipImageY: the same for top and bottom
    bool flip_subpixels = false; ///< flipSubp: blue is on the left. No published calibration sets
                                 ///< flipImageX or flipSubp: both follow the shaders' text alone.
    Subpixels cells; ///< from subpixelCells and CellPatternMode, counted from the top left; none:
                     ///< the formula's stripes
    std::optional<PanelQuilt> quilt;  ///< defaultQuilt, as Looking Glass Bridge reports it for a
                                      ///< display: not part of the mapping
    std::vector<std::string> assumed; ///< assumptions about the display, a line each: "viewCone is
                                      ///< missing: ..."
};

/// Thrown for a document without any calibration.
struct NoCalibration : std::invalid_argument {
    static constexpr const char*
        requested = "an object with pitch, slope, center, DPI, screenW and screenH";
    NoCalibration() : std::invalid_argument(std::string("holds no calibration: ") + requested) {}
};

/// Reads a calibration, its numbers plain or as {"value": x}, alone or within the wrappers of
/// Looking Glass Bridge and HoloPlay Core (lists of devices, with the calibration as a string of
/// JSON, and perhaps the display's quilt next to it). Fields that may be missing have the defaults
/// above; `assumed` then lists the consequences. Throws std::invalid_argument naming the field, or
/// if there are several displays' calibrations; NoCalibration if there is none.
LookingGlassCalibration looking_glass_from_json(const Json& document);

/// A document that looking_glass_from_json reads back to the same doubles.
Json json_of(const LookingGlassCalibration& calibration);

/// The published mapping: a place in [0, 1) from the leftmost view to the rightmost, for a colour
/// (0 red, 1 green, 2 blue) of the pixel in a column and a row, counted from the top left of the
/// image that is sent to the display.
///
/// Makers' shaders differ in the flips. If flipImageX is set, the shader for Unity takes picture
/// and phase at 1 - u, and negates tilt and subpixel step. Together, these changes leave lenses and
/// colours at their places on the display and reverse the views, as a mirror does. Later shaders
/// only negate tilt and step, and the picture is mirrored afterwards, which is equivalent. With
/// flipImageY, the picture, but not the phase, is taken at 1 - v. So the picture must be sampled
/// mirrored, and the mapping is that of the display without flips, except for the order of the
/// views.
///
/// Views run in the direction of decreasing phase, as they do behind every lens, whatever invView
/// is: real displays of the third generation have invView 0, and the makers' shaders for these
/// displays do not read it. (The makers' first shaders for browsers did; every file of that time
/// has 1.)
double view_of_subpixel(const LookingGlassCalibration& calibration, int column, int row,
                        int channel);

} // namespace integral

#endif
