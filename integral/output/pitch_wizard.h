// SPDX-License-Identifier: AGPL-3.0-or-later
// A lens sheet's pitch and index from readings of a pitch chart, such as "bars 12 and 13 look even
// from 400 mm".
//
// The bar that looks even to an eye at distance D has the film pitch q = p (1 + t/(nD)). That is
// exact for lenses on the axis, and linear in 1/D. (For a whole bar, seen from at least twice its
// length, t/n comes out within 1.2%.) One distance gives p if t/n is known. Two or more distances
// give a line, whose value at 1/D = 0 is p, and whose slope is p t/n.
#ifndef INTEGRAL_OUTPUT_PITCH_WIZARD_H
#define INTEGRAL_OUTPUT_PITCH_WIZARD_H

#include "integral/optics/lens_sheet.h"

#include <string>
#include <vector>

namespace integral {

/// The bars of a chart: bar k, counted from 1, has the film pitch first + (k - 1) step. first and
/// step > 0, mm; bars >= 1. The bars of a second direction continue the numbers: bar k + bars has
/// the pitch of bar k.
struct PitchScale {
    double first = 0, step = 0;
    int bars = 0;
};

/// The film pitch of a bar of either direction.
double film_pitch(const PitchScale& scale, int bar);

/// Inverse: the bar, as a number that need not be whole, that would have a film pitch.
double bar_of_pitch(const PitchScale& scale, double pitch);

struct ChartReading {
    std::vector<int> bars; ///< the bars that look equally even: one, or neighbours; or one or more
                           ///< neighbours of each direction
    double distance = 0;   ///< mm from the eye to the lenses, > 0
};

/// A figure and its error: how far the truth may be from it if every reading is right to half a
/// step.
struct Measured {
    double value = 0, error = 0;
};

/// The film pitch that a reading gives: the mean of its bars. The error is half a step, or half the
/// range of the bars where that is more. Throws std::invalid_argument where a bar is not on the
/// chart, or the bars are no neighbours.
Measured film_pitch_of(const PitchScale& scale, const ChartReading& reading);

struct MeasuredSheet {
    Measured pitch; ///< the lenses' own pitch, mm
    Measured index; ///< given the sheet's thickness; its error is 0 where it was not measured
    bool index_measured = false;
    double least_index = 0;    ///< the least index that the readings' errors allow, >= 1
    double greatest_index = 0; ///< the greatest; 0: there is no bound
};

/// Computes the pitch from one reading, and from two or more the index as well, by least squares.
/// `keep_index`: the index is the sheet's, only the pitch is measured. Throws
/// std::invalid_argument, with one line for the user, where several readings are all from one
/// distance and the index is to be measured; where the index comes out below 1 or above 4; and
/// where a reading is farther from the others than the errors explain.
MeasuredSheet measured_sheet(const LensSheet& sheet, const PitchScale& scale,
                             const std::vector<ChartReading>& readings, bool keep_index = false);

} // namespace integral

#endif
