// SPDX-License-Identifier: AGPL-3.0-or-later
// How long POV-Ray's threads sleep before they look again. Start and end of a run are a dozen such looks one after another:
// with POV-Ray's own 50 to 200 ms they took 0.7 s, whatever the scene.
#ifndef POVRAY_INTEGRAL_WAITS_H
#define POVRAY_INTEGRAL_WAITS_H

namespace vfe
{
	/// Milliseconds. Shorter would cost more than 1% of a core.
	constexpr unsigned int IntegralWait = 5;

	/// Nanoseconds by which a wait of `milliseconds` is longer.
	constexpr long IntegralWaitExcess(unsigned int milliseconds)
	{
		return (long(milliseconds) - long(IntegralWait)) * 1000000;
	}
}

#endif
