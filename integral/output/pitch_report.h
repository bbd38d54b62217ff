// SPDX-License-Identifier: AGPL-3.0-or-later
// What the readings of a pitch chart say of a sheet, as text and as JSON.
#ifndef INTEGRAL_OUTPUT_PITCH_REPORT_H
#define INTEGRAL_OUTPUT_PITCH_REPORT_H

#include "integral/output/pitch_wizard.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace integral {

/// `found` is measured_sheet's answer for these arguments. Where the readings hardly tell the
/// index, the text says so and what the pitch is by the nominal one.
std::string pitch_report_text(const LensSheet& nominal, const PitchScale& scale,
                              const std::vector<ChartReading>& readings,
                              const MeasuredSheet& found);

/// The same figures, lengths in mm; an index without an upper bound has ior_greatest null.
nlohmann::ordered_json pitch_report_json(const PitchScale& scale,
                                         const std::vector<ChartReading>& readings,
                                         const MeasuredSheet& found);

} // namespace integral

#endif
