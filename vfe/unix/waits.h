// SPDX-License-Identifier: AGPL-3.0-or-later
// The waiting times of POV-Ray's threads.
#ifndef POVRAY_VFE_WAITS_H
#define POVRAY_VFE_WAITS_H

#include <chrono>
#include <thread>

namespace vfe
{
/// The longest time in milliseconds that a polling thread sleeps. Starting and ending a run takes
/// about a dozen such sleeps in sequence; at upstream's 50 to 200 ms each they take 0.7 s for any
/// scene. Less than 5 ms would cost more than 1% of a core.
constexpr unsigned int LongestSleep = 5;

/// Waits until `started()` returns true, but at most a minute; polls every millisecond. Upstream's
/// wait for a condition variable misses a signal that comes between its test and its wait, which
/// ended one run in several hundred on a busy machine.
template <class Started> void AwaitStart(Started started)
{
    using namespace std::chrono;
    const auto end = steady_clock::now() + minutes(1);
    while (!started() && steady_clock::now() < end)
        std::this_thread::sleep_for(milliseconds(1));
}
}

#endif
