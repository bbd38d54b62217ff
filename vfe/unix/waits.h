// SPDX-License-Identifier: AGPL-3.0-or-later
// How long POV-Ray's threads wait for each other.
#ifndef POVRAY_VFE_WAITS_H
#define POVRAY_VFE_WAITS_H

#include <chrono>
#include <thread>

namespace vfe
{
/// The longest time in milliseconds that a polling thread sleeps. The start and the end of a run
/// are a dozen such sleeps one after another: with 50 to 200 ms each they took 0.7 s, whatever the
/// scene. Less than 5 ms would cost more than 1% of a core.
constexpr unsigned int LongestSleep = 5;

/// Waits until `started()` holds, for a minute at most, and asks every millisecond. Waiting for a
/// condition variable instead loses a signal that comes between the look and the wait; that ended
/// one run of several hundred on a busy machine.
template <class Started> void AwaitStart(Started started)
{
    using namespace std::chrono;
    const auto end = steady_clock::now() + minutes(1);
    while (!started() && steady_clock::now() < end)
        std::this_thread::sleep_for(milliseconds(1));
}
}

#endif
