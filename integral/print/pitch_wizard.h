// SPDX-License-Identifier: AGPL-3.0-or-later
// Computes a lens sheet's pitch and index from readings of a pitch chart, such as "bars 12 and 13
// look even from 400 mm".
//
// The bar that looks even to an eye at distance D has the film pitch q = p (1 + t/(nD)). That is
// exact for lenses on the axis, and linear in 1/D. (For a whole bar, seen from at least twice its
// length, t/n is right within 1.2%.) One distance gives p if t/n is known. Two or more distances
// give a line; its value at 1/D = 0 is p, and its slope is p t/n.
#ifndef INTEGRAL_PRINT_PITCH_WIZARD_H
#define INTEGRAL_PRINT_PITCH_WIZARD_H

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

/// Inverse of film_pitch: the bar with a film pitch, as a number that need not be whole.
double bar_of_pitch(const PitchScale& scale, double pitch);

struct ChartReading {
    std::vector<int> bars; ///< the bars that look equally even: one or more neighbouring bars, of
                           ///< one direction or of both
    double distance = 0;   ///< mm from the eye to the lenses, > 0
};

/// A figure and its error bound, which holds if every reading is right to half a step.
struct Measured {
    double value = 0, error = 0;
};

/// The film pitch that a reading gives: the mean of its bars. The error bound is half a step, or
/// half the bars' range of pitches if that is more. Throws std::invalid_argument if a bar is not on
/// the chart, or if the bars are not neighbours.
Measured film_pitch_of(const PitchScale& scale, const ChartReading& reading);

struct MeasuredSheet {
    Measured pitch; ///< the lenses' own pitch, mm
    Measured index; ///< for the sheet's thickness; error 0: the index was not measured
    bool index_measured = false;
    double least_index = 0;    ///< the least index that the readings' error bounds allow, >= 1
    double greatest_index = 0; ///< the greatest such index; 0: there is no bound
};

/// Computes the pitch from one reading, and from two or more the index as well, by least squares.
/// `keep_index`: the index is the sheet's, and only the pitch is measured. Throws
/// std::invalid_argument, with one line for the user, if the index is to be measured and all
/// readings are from one distance; if the index is below 1 or above 4; and if a reading is farther
/// from the fit than twice its error bound.
MeasuredSheet measured_sheet(const LensSheet& sheet, const PitchScale& scale,
                             const std::vector<ChartReading>& readings, bool keep_index = false);

} // namespace integral

#endif
