// SPDX-License-Identifier: AGPL-3.0-or-later
// The calibration files of Looking Glass displays, and the mapping from a subpixel to a view that
// their makers publish.
#ifndef INTEGRAL_OUTPUT_LOOKING_GLASS_H
#define INTEGRAL_OUTPUT_LOOKING_GLASS_H

#include "integral/base/json.h"
#include "integral/optics/subpixels.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace integral {

/// The fields of a calibration, in the units that they have in the file (visual.json). Every
/// display has one of its own.
struct LookingGlassCalibration {
    std::string version, serial; ///< configVersion, serial
    double pitch = 0; ///< micro-images per inch, across the lenses: seen from where the views meet,
                      ///< so a little fewer than the lenses; > 0
    double slope = 0; ///< of the lenses, height by width: positive where they lean to the left
                      ///< going up; not 0
    double center = 0;          ///< phase of the mapping, in micro-images
    double view_cone = 40;      ///< viewCone: degrees that the views span, left to right
    double vertical_angle = 0;  ///< verticalAngle, degrees: for cameras, no part of the mapping
    double fringe = 0;          ///< no part of the mapping either
    double dpi = 0;             ///< DPI: pixels per inch, both ways
    int width = 0, height = 0;  ///< screenW, screenH: pixels
    bool inverted_views = true; ///< invView: handed on, and no part of the mapping; see
                                ///< view_of_subpixel
    bool flip_x = false; ///< flipImageX, flipImageY: the display is seen in a mirror, and the
                         ///< picture that it is sent is
    bool flip_y = false; ///< mirrored so; see view_of_subpixel
    bool flip_subpixels = false; ///< flipSubp: blue is on the left
                                 ///< No published calibration sets flipImageX or flipSubp: they
                                 ///< rest on the shaders' text alone.
    Subpixels cells; ///< of subpixelCells and CellPatternMode, on the display itself; none: the
                     ///< stripes of the formula
    std::vector<std::string> assumed; ///< what had to be assumed of the display, a line each:
                                      ///< "viewCone is missing: ..."
};

/// What is thrown of a document without any calibration.
struct NoCalibration : std::invalid_argument {
    static constexpr const char*
        wanted = "an object with pitch, slope, center, DPI, screenW and screenH";
    NoCalibration() : std::invalid_argument(std::string("holds no calibration: ") + wanted) {}
};

/// Reads the file, its numbers plain or as {"value": x}; also what Looking Glass Bridge and
/// HoloPlay Core wrap around it (lists of devices, the calibration a string of JSON within). Fields
/// that it may lack have the defaults above; what they decide is then in `assumed`. Throws
/// std::invalid_argument naming the field, or where there are several displays' calibrations;
/// NoCalibration where there is none.
LookingGlassCalibration looking_glass_from_json(const Json& document);

/// A document that looking_glass_from_json reads back to the same doubles.
Json json_of(const LookingGlassCalibration& calibration);

/// The published mapping: in [0, 1) from the leftmost view to the rightmost, for a colour (0 red, 1
/// green, 2 blue) of the pixel of a column and a row, counted from the top left of the image that
/// the display is sent.
///
/// Makers' shaders differ in the flips. The one for Unity takes picture and phase at 1 - u where
/// flipImageX is set, and negates tilt and subpixel step there: the two together leave lenses and
/// colours where they are on the display and turn the views round, which is what a mirror does.
/// Later ones negate alone, for a picture that is mirrored after them, which comes to the same.
/// flipImageY takes the picture, and not the phase, at 1 - v. So the picture is to be sampled
/// mirrored, and the mapping is the display's own but for the views' order.
///
/// Views run against the phase, as they do behind every lens, whatever invView says: real displays
/// of the third generation have it as 0 and the makers' shaders for them do not read it. (Their
/// first shaders for browsers did; every file of that time has 1.)
double view_of_subpixel(const LookingGlassCalibration& calibration, int column, int row,
                        int channel);

} // namespace integral

#endif
