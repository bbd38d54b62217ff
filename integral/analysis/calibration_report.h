// SPDX-License-Identifier: AGPL-3.0-or-later
// Reports on a sheet's calibration.
#ifndef INTEGRAL_ANALYSIS_CALIBRATION_REPORT_H
#define INTEGRAL_ANALYSIS_CALIBRATION_REPORT_H

#include "integral/analysis/sheet_calibration.h"
#include "integral/base/json.h"

#include <string>

namespace integral {

/// The nominal sheet with the measured pitch, slant, offset, and the index that gives the measured
/// t/n with the nominal thickness.
LensSheet calibrated_sheet(LensSheet nominal, const SheetCalibration& found);

/// The figures as JSON.
Json calibration_json(const LensSheet& nominal, const SheetCalibration& found);

/// The figures as text, in several lines.
std::string calibration_text(const LensSheet& nominal, const SheetCalibration& found);

} // namespace integral

#endif
