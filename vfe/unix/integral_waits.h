// SPDX-License-Identifier: AGPL-3.0-or-later
// How long POV-Ray's threads wait for each other.
#ifndef POVRAY_INTEGRAL_WAITS_H
#define POVRAY_INTEGRAL_WAITS_H

#include <chrono>
#include <thread>

namespace vfe
{
	/// Milliseconds that a thread sleeps before it looks again. Start and end of a run are a dozen such looks one after another: with
	/// POV-Ray's own 50 to 200 they took 0.7 s, whatever the scene. Shorter would cost more than 1% of a core.
	constexpr unsigned int IntegralWait = 5;

	/// Nanoseconds by which a wait of `milliseconds` is longer.
	constexpr long IntegralWaitExcess(unsigned int milliseconds)
	{
		return (long(milliseconds) - long(IntegralWait)) * 1000000;
	}

	/// Waits until `started()`, for a minute at most, with a look every millisecond. POV-Ray waits for two to three seconds, and for a signal that
	/// is lost if it comes between its look and its wait: on a busy machine one run of several hundred ended so, before it began.
	template <class Started>
	void IntegralAwaitStart(Started started)
	{
		using namespace std::chrono;
		const auto end = steady_clock::now() + minutes(1);
		while (!started() && steady_clock::now() < end)
			std::this_thread::sleep_for(milliseconds(1));
	}
}

#endif
