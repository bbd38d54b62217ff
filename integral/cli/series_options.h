// SPDX-License-Identifier: AGPL-3.0-or-later
// The options for writing and playing an animation: --fps and --quality.
#ifndef INTEGRAL_CLI_SERIES_OPTIONS_H
#define INTEGRAL_CLI_SERIES_OPTIONS_H

#include "integral/cli/command.h"
#include "integral/io/picture_series.h"

namespace integral {

struct SeriesOptions {
    std::optional<std::string> fps;
    std::optional<int> quality;
};

void declare(options::options_description& all, SeriesOptions& series);

/// Throws UsageError if these options are given for an output that is no animation.
void check_series_options(const SeriesOptions& given, const std::string& output);

/// Settings of an animation that plays from the first picture to the last. Throws UsageError.
AnimationSettings animation_settings(const SeriesOptions& given);

} // namespace integral

#endif
