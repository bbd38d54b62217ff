// SPDX-License-Identifier: AGPL-3.0-or-later
// Reports the readings of a pitch chart and the sheet's measures that they give, as text and as
// JSON.
#ifndef INTEGRAL_PRINT_PITCH_REPORT_H
#define INTEGRAL_PRINT_PITCH_REPORT_H

#include "integral/print/pitch_wizard.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace integral {

/// `found` is measured_sheet's result for these arguments. If the readings hardly determine the
/// index, the text says so and gives the pitch for the nominal index.
std::string pitch_report_text(const LensSheet& nominal, const PitchScale& scale,
                              const std::vector<ChartReading>& readings,
                              const MeasuredSheet& found);

/// The same figures, lengths in mm; an index without an upper bound has ior_greatest null.
nlohmann::ordered_json pitch_report_json(const PitchScale& scale,
                                         const std::vector<ChartReading>& readings,
                                         const MeasuredSheet& found);

} // namespace integral

#endif
