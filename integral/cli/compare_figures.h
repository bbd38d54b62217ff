// SPDX-License-Identifier: AGPL-3.0-or-later
// Limits as options, and figures for programs: of two pictures and of a suite.
#ifndef INTEGRAL_CLI_COMPARE_FIGURES_H
#define INTEGRAL_CLI_COMPARE_FIGURES_H

#include "integral/cli/command.h"
#include "integral/replay/compare_limits.h"

#include <nlohmann/json_fwd.hpp>

namespace integral {

/// --max-rmse and its like, one for each of limit_kinds.
void add_limit_options(options::options_description& all);

/// What they say. Throws UsageError.
Limits limits_from(const options::variables_map& arguments);

/// A comparison's figures; a PSNR that is infinite, and a micro-image that is not there, are null.
nlohmann::ordered_json figures_json(const Comparison& comparison);

} // namespace integral

#endif
