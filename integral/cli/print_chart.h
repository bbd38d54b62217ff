// SPDX-License-Identifier: AGPL-3.0-or-later
// Pitch charts of `integral print`: --chart makes one, --even measures a sheet with one.
#ifndef INTEGRAL_CLI_PRINT_CHART_H
#define INTEGRAL_CLI_PRINT_CHART_H

#include "integral/cli/print_options.h"
#include "integral/print/chart_page.h"

namespace integral {

/// The nominal geometry of a chart. Its film has a size only if --size is given. `start`: the file
/// of --sheet. Throws UsageError, InputError.
FrameMetadata nominal_geometry(const std::optional<std::string>& start, const SheetOptions& sheet,
                               const FilmOptions& film);

/// Sets the size in pixels of a calibration page's film from --page, unless it has one.
void set_calibration_page(const std::optional<std::string>& page, Film& film);

/// The value of --distance, mm, or a chart's default. Throws UsageError.
double chart_distance(const std::optional<std::string>& distance);

/// The chart of --chart or the page of --calibration. Throws UsageError, InputError.
ChartPage chart_of(const PrintOptions& o);

/// Executes --chart, --calibration or --even: writes the chart to -o's FILE and prints the command
/// that reads it; or prints the sheet's figures from the readings, and writes the sheet's corrected
/// geometry to -o's FILE. Returns an ExitStatus; throws as a Command's `run` does.
int make_chart(const PrintOptions& o);

} // namespace integral

#endif
