// SPDX-License-Identifier: AGPL-3.0-or-later
// The option --threads, shared by commands.
#ifndef INTEGRAL_CLI_THREAD_OPTIONS_H
#define INTEGRAL_CLI_THREAD_OPTIONS_H

#include "integral/cli/command.h"

namespace integral {

struct ThreadOptions {
    std::optional<int> given;
    /// Number of threads; 0: one per core. Throws UsageError for too many.
    int count() const;
};

void declare(options::options_description& all, ThreadOptions& threads);

} // namespace integral

#endif
