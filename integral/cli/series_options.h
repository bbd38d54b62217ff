// SPDX-License-Identifier: AGPL-3.0-or-later
// The options that say how an animation is written and played: --fps and --quality.
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

/// Throws UsageError where they are given for an output that is no animation.
void check_series_options(const SeriesOptions& given, const std::string& output);

/// Begins a series of `count` pictures that goes to `output`, numbered from `first` on. An
/// animation plays `there_and_back` or from the first to the last. Throws UsageError for what the
/// options say, and where `output` is "-"; else as PictureSeries does.
PictureSeries begin_series(const SeriesOptions& given, const std::string& output, int count,
                           int first, bool there_and_back);

} // namespace integral

#endif
