// SPDX-License-Identifier: AGPL-3.0-or-later
// The limits of a comparison as options.
#ifndef INTEGRAL_CLI_COMPARE_OPTIONS_H
#define INTEGRAL_CLI_COMPARE_OPTIONS_H

#include "integral/cli/command.h"
#include "integral/compare/compare_limits.h"

namespace integral {

/// --max-rmse and its like, one for each of limit_kinds.
void add_limit_options(options::options_description& all);

/// What they say. Throws UsageError.
Limits limits_from(const options::variables_map& arguments);

} // namespace integral

#endif
