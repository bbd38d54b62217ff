// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/thread_options.h"

#include "integral/cli/values.h"

namespace integral {

void declare(options::options_description& all, ThreadOptions& threads)
{
    add(all, "threads", threads.given, "N (=0)", "threads to work with (0: one per core)");
}

int ThreadOptions::count() const
{
    constexpr int most_threads = 1024;
    return in_range("threads", given.value_or(0), 0, most_threads);
}

} // namespace integral
