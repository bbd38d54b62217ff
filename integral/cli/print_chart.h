// SPDX-License-Identifier: AGPL-3.0-or-later
// Pitch charts of `integral print`: --chart makes one, --even measures a sheet with one.
#ifndef INTEGRAL_CLI_PRINT_CHART_H
#define INTEGRAL_CLI_PRINT_CHART_H

#include "integral/cli/print_options.h"
#include "integral/print/chart_page.h"

namespace integral {

/// The chart of --chart. Throws UsageError, InputError.
ChartPage chart_of(const PrintOptions& o);

/// Executes --chart or --even: writes the chart to -o's FILE and prints the command that reads it;
/// or prints the sheet's figures from the readings, and writes the sheet's corrected geometry to
/// -o's FILE. Returns an ExitStatus; throws as a Command's `run` does.
int make_chart(const PrintOptions& o);

} // namespace integral

#endif
