// SPDX-License-Identifier: AGPL-3.0-or-later
// Pitch charts of `integral print`: --chart makes one, --even goes from what is even on it to a
// sheet file.
#ifndef INTEGRAL_CLI_PRINT_CHART_H
#define INTEGRAL_CLI_PRINT_CHART_H

#include "integral/cli/command.h"
#include "integral/lightfield/frame.h"

namespace integral {

/// Adds --chart, --even, --keep-index, --pitch-range, --pitch-step, --bars, --page and the options
/// of geometry_options.h, except those that `all` has already. The command's own are --sheet,
/// --json and --output.
void add_chart_options(options::options_description& all);

/// Whether the command line asks for a chart or reads one.
bool is_chart(const options::variables_map& arguments);

/// A chart as it is printed.
struct ChartPage {
    Frame frame;         ///< with its geometry
    std::string reading; ///< "Read it by: COMMAND", the page's last line
};

/// The chart that --chart asks for. Throws UsageError, InputError.
ChartPage chart_page(const options::variables_map& arguments);

/// Writes the chart to -o's FILE and prints the command that reads it; or prints what the readings
/// of --even say and writes the corrected geometry to -o's FILE. Returns an ExitStatus or throws as
/// a Command's `run`.
int make_chart(const options::variables_map& arguments);

} // namespace integral

#endif
