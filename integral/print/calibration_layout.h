// SPDX-License-Identifier: AGPL-3.0-or-later
// Layout of the calibration page: one print, laid under a lens sheet and photographed once,
// measures the sheet.
//
// Four targets stand in the page's corners, and a strip of squares runs between them, two squares
// wide. A reader finds the targets at any angle, and the points where four squares meet give it the
// camera. Dots in white squares are a code for the options that the page was made with. The sheet
// is laid on the field inside the strip. The field is divided into groups of bands, which run
// across the lenses:
// - beat: lines of the pitch at which the lenses image the film, slightly tilted. Each lens shows a
//   dot of one line, so that the sheet turns the lines' phase against the lenses into brightness:
//   the tilt makes fringes across the lenses, and their place gives the phase, whatever light and
//   contrast are. The tilt changes its sign from group to group, so that no turn of the sheet up to
//   5 degrees can be mistaken for another.
// - leak: the same with narrow lines: light that an eye gets from a neighbouring place has leaked.
// - coarse: light and dark as far apart as several lenses, seen through the sheet as through a
//   plate of glass. Their displacement depends on thickness and index. The light changes as a sine,
//   which the lenses' sampling does not displace.
// - tints: fine lines perpendicular to the others, which lenticular lenses do not magnify, and
//   plain white and black, for the dot gain.
#ifndef INTEGRAL_PRINT_CALIBRATION_LAYOUT_H
#define INTEGRAL_PRINT_CALIBRATION_LAYOUT_H

#include "integral/print/chart_lines.h"

#include <array>

namespace integral {

struct CalibrationPage {
    LensSheet sheet;       ///< the nominal sheet; its offset is not used
    Film film;             ///< the whole page
    double distance = 400; ///< mm from which the sheet is photographed, about
};

/// Width of a leak line, pitches.
constexpr double leak_line = 1.0 / 6;

enum class BandKind { beat, leak, coarse, tint };

/// A band of lines (a sine of light, if it is coarse); the middle of a light one passes through the
/// page's middle. The rectangle of ChartLines is in the page's pixels.
struct CalibrationBand : ChartLines {
    BandKind kind;
    int group; ///< from the top (left) of the page
};

/// Period of the fine lines of tints, and of those that make up a coarse band, mm. They run across
/// the lenses.
double tint_period(const CalibrationPage& page);

/// A disc, a white ring in it and a black dot in the ring.
struct CalibrationTarget {
    Vec2 middle; ///< mm, sheet frame
    double dot;  ///< the dot's radius, mm; the first target has the largest
};

constexpr double target_disc = 5.6, target_ring = 4.1, first_dot = 2.7, other_dot = 1.5; // mm

/// A rectangle of black, in the page's pixels.
struct BlackSquare {
    int left, top, right, bottom;
};

/// A white square of the strips. The squares with dots are the bits of a checksum of the page's
/// sheet, film and distance, again and again.
struct CodeSquare {
    Vec2 middle, black; ///< middles of the square and of a black one beside it, mm, sheet frame
    bool dot;           ///< black, of code_dot, in its middle
};

constexpr double code_dot = 0.7; ///< radius, mm

struct CalibrationLayout {
    /// Top left, top right, bottom right, bottom left.
    std::array<CalibrationTarget, 4> targets;
    std::vector<BlackSquare> squares;
    std::vector<CodeSquare> code;
    std::vector<Vec2> corners; ///< points where four squares meet, mm in the sheet frame
    std::vector<CalibrationBand> bands;
    int groups = 0;
    double field_left, field_top, field_width, field_height; ///< mm from the page's left and top
};

/// Period of the coarse sine, mm: a whole number of pitches and a half, so that no harmonic that
/// dot gain adds, sampled by the lenses, looks like the fundamental.
double coarse_period(const LensSheet& sheet);

/// Height of the page's heading in the field's upper end, mm.
constexpr double calibration_heading = 14;

/// Throws std::invalid_argument, with advice, for sheets that are not lenticular, if the page has
/// no room for three groups, or if the film's pixels are too large for the lines.
CalibrationLayout calibration_layout(const CalibrationPage& page);

} // namespace integral

#endif
