// SPDX-License-Identifier: AGPL-3.0-or-later
// From "bars 12 and 13 look even at 400 mm" to a lens sheet's pitch and index.
//
// The bar that an eye at distance D sees even has the film pitch q = p (1 + t/(nD)): exact for
// lenses on the axis, and linear in 1/D. (From twice a bar's length on, what the whole bar shows is
// within 1.2% of that t/n.) At one distance and with t/n known, q gives p; from two distances on,
// the line's two numbers give p and t/n.
#ifndef INTEGRAL_OUTPUT_PITCH_WIZARD_H
#define INTEGRAL_OUTPUT_PITCH_WIZARD_H

#include "integral/optics/lens_sheet.h"

#include <string>
#include <vector>

namespace integral {

/// The bars of a chart: bar k, from 1, has the film pitch first + (k - 1) step. mm; first and step
/// > 0, bars >= 1. Bars of a second direction are numbered on: bar k + bars has bar k's pitch.
struct PitchScale {
    double first = 0, step = 0;
    int bars = 0;
};

/// The film pitch of a bar of either direction.
double film_pitch(const PitchScale& scale, int bar);

/// The place on the scale, as a number of a bar that need not be whole, of a film pitch.
double bar_of_pitch(const PitchScale& scale, double pitch);

struct ChartReading {
    std::vector<int> bars; ///< that look even, alike: one, or neighbours (of one direction, or
                           ///< both)
    double distance = 0;   ///< mm from the eye to the lenses, > 0
};

/// A figure, and how far the truth may be from it where every reading is right to half a step.
struct Measured {
    double value = 0, error = 0;
};

/// What one reading says: its bars' mean film pitch, to half a step, or to half the range of its
/// bars where that is more. Throws std::invalid_argument where a bar is not on the chart, or the
/// bars are no neighbours.
Measured film_pitch_of(const PitchScale& scale, const ChartReading& reading);

struct MeasuredSheet {
    Measured pitch; ///< the lenses' own, mm
    Measured index; ///< for the sheet's thickness; error 0 where it was not measured
    bool index_measured = false;
    double least_index = 0, greatest_index = 0; ///< what the readings' errors allow, at least 1;
                                                ///< greatest_index 0: no bound
};

/// The mechanical pitch, and from two readings on the index, which `keep_index` leaves as the sheet
/// has it. Least squares. Throws std::invalid_argument in one line: readings from one distance only
/// (there are several and the index is asked for), an index below 1 or above 4, readings that are
/// farther from the rest than their own errors explain.
MeasuredSheet measured_sheet(const LensSheet& sheet, const PitchScale& scale,
                             const std::vector<ChartReading>& readings, bool keep_index = false);

} // namespace integral

#endif
