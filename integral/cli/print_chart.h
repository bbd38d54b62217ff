// SPDX-License-Identifier: AGPL-3.0-or-later
// Pitch charts of `integral print`: --chart makes one, --even measures a sheet by one.
#ifndef INTEGRAL_CLI_PRINT_CHART_H
#define INTEGRAL_CLI_PRINT_CHART_H

#include "integral/cli/print_options.h"
#include "integral/output/chart_page.h"

namespace integral {

/// The chart that --chart asks for. Throws UsageError, InputError.
ChartPage chart_of(const PrintOptions& o);

/// Does what --chart and --even ask for: writes the chart to -o's FILE and prints the command that
/// reads it; or prints what the readings say of the sheet, and writes its corrected geometry to
/// -o's FILE. Returns an ExitStatus; throws as a Command's `run` does.
int make_chart(const PrintOptions& o);

} // namespace integral

#endif
