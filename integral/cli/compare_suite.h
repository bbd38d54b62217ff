// SPDX-License-Identifier: AGPL-3.0-or-later
// compare's option --suite: a folder of pictures against their references.
#ifndef INTEGRAL_CLI_COMPARE_SUITE_H
#define INTEGRAL_CLI_COMPARE_SUITE_H

#include "integral/cli/command.h"

namespace integral {

/// --suite and the options that go with it.
void add_suite_options(options::options_description& all);

/// Throws UsageError where one of them was given without --suite.
void refuse_suite_options(const options::variables_map& arguments);

/// Compares the suite, or accepts references: what `compare` does with --suite. As Command::run.
int run_suite(const options::variables_map& arguments);

} // namespace integral

#endif
