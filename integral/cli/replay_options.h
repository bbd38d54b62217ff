// SPDX-License-Identifier: AGPL-3.0-or-later
// The options of `integral replay`, and the views that they describe.
#ifndef INTEGRAL_CLI_REPLAY_OPTIONS_H
#define INTEGRAL_CLI_REPLAY_OPTIONS_H

#include "integral/cli/fit_options.h"
#include "integral/cli/series_options.h"
#include "integral/cli/thread_options.h"
#include "integral/replay/replay_series.h"

namespace integral {

struct ReplayOptions : CommonOptions {
    std::optional<std::string> output, html, sheet;
    std::optional<std::string> eye, size, part, pupil, focus, lens_model, film_gap, lens_blur;
    std::optional<int> samples;
    std::optional<std::string> stereo, grid, path;
    bool cross_eyed = false, anaglyph = false, half = false, raw_draft = false, as_seen = false;
    std::optional<int> steps;
    FitOptions fit;
    ThreadOptions threads;
    SeriesOptions series;
};

void declare(options::options_description& all, ReplayOptions& o);

/// The view. An eye or a size that is not given stays 0; the frame supplies it. Throws UsageError.
View view_of(const ReplayOptions& o);

/// Throws UsageError.
ViewArrangement arrangement_of(const ReplayOptions& o);

/// The movement of the eye, if any. Throws UsageError.
std::optional<EyeMovement> movement_of(const ReplayOptions& o);

} // namespace integral

#endif
