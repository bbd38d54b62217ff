// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/progress.h"

#include "integral/cli/command.h"

#include <csignal>
#include <cstdio>
#include <string>
#include <unistd.h>

namespace integral {
namespace {

volatile std::sig_atomic_t stop_requested = 0;

void on_signal(int) { stop_requested = 1; }

} // namespace

void catch_interrupts()
{
    struct sigaction action = {};
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESETHAND; // a second one does what it always does
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction before;
        if (sigaction(signal, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
            sigaction(signal, &action, nullptr);
    }
}

bool interrupted() { return stop_requested != 0; }

void stop_if_interrupted()
{
    if (interrupted())
        throw Interrupted();
}

Progress progress_bar(const char* what)
{
    const bool terminal = isatty(STDERR_FILENO);
    int shown = -1;
    return [=](int done, int total) mutable {
        const int percent = int(100.0 * done / total);
        if (terminal && percent != shown) {
            shown = percent;
            const std::string bar = std::string(percent / 2, '#') + std::string(50 - percent / 2, '.');
            std::fprintf(stderr, "\r%s [%s] %3d%%%s", what, bar.c_str(), percent,
                         done == total ? "\r\033[K" : "");
            std::fflush(stderr);
        }
        return !interrupted();
    };
}

} // namespace integral
