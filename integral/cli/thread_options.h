// SPDX-License-Identifier: AGPL-3.0-or-later
// The option --threads, for every command that has it.
#ifndef INTEGRAL_CLI_THREAD_OPTIONS_H
#define INTEGRAL_CLI_THREAD_OPTIONS_H

#include "integral/cli/command.h"

namespace integral {

struct ThreadOptions {
    std::optional<int> given;
    /// Threads to work with; 0: one per core. Throws UsageError for more than there can be.
    int count() const;
};

void declare(options::options_description& all, ThreadOptions& threads);

} // namespace integral

#endif
