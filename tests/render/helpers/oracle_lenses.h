// SPDX-License-Identifier: AGPL-3.0-or-later
// The lattice and single lenses of the oracle (oracle.h), for its own files.
#ifndef TESTS_RENDER_HELPERS_ORACLE_LENSES_H
#define TESTS_RENDER_HELPERS_ORACLE_LENSES_H

#include "oracle.h"

#include <cmath>
#include <functional>
#include <limits>

namespace oracle {

const Real pi = std::acos(-1.0L);
const Real infinity = std::numeric_limits<Real>::infinity();

/// The refractive index that the model uses: 1 for the pinhole.
Real index(const Description& d);

/// Whether the model refracts light at a curved surface.
bool curved(const Description& d);

/// Whether a lenticular sheet's slit is horizontal.
bool horizontal_slit(const Description& d);

/// A lens's pole; for a lenticular sheet, the point of the lens's axis that is nearest to the
/// lattice's origin.
Point2 pole(const Description& d, Lens lens);

/// The distance of a film point from the lens's pole, or for a lenticular sheet from its axis.
Real lens_distance(const Description& d, Point2 f, Lens lens);

/// Calls `visit` with every lens within `reach` of the film point.
void each_lens(const Description& d, Point2 f, Real reach, const std::function<void(Lens)>& visit);

} // namespace oracle

#endif
