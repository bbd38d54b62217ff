// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/base/interrupt.h"

#include <csignal>

namespace integral {
namespace {

volatile std::sig_atomic_t stop_requested = 0;

void on_signal(int) { stop_requested = 1; }

} // namespace

void catch_interrupts()
{
    struct sigaction action = {};
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESETHAND; // a second signal has its default effect
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

} // namespace integral
