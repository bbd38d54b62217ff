// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/progress.h"

#include <cstdio>
#include <string>
#include <unistd.h>

namespace integral {
Progress progress_bar(const char* what)
{
    const bool terminal = isatty(STDERR_FILENO);
    int shown = -1;
    return [=](int done, int total) mutable {
        const int percent = int(100.0 * done / total);
        if (terminal && percent != shown) {
            shown = percent;
            const std::string bar = std::string(percent / 2, '#') +
                                    std::string(50 - percent / 2, '.');
            std::fprintf(stderr, "\r%s [%s] %3d%%%s", what, bar.c_str(), percent,
                         done == total ? "\r\033[K" : "");
            std::fflush(stderr);
        }
        return !interrupted();
    };
}

} // namespace integral
