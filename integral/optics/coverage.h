// SPDX-License-Identifier: AGPL-3.0-or-later
// Measures what share of a camera's film is imaged, and why the remaining share is not.
#ifndef INTEGRAL_OPTICS_COVERAGE_H
#define INTEGRAL_OPTICS_COVERAGE_H

#include "integral/optics/camera.h"

namespace integral {

/// Fractions of the film's pixels, 0 to 1. The first three add up to 1.
struct Coverage {
    double imaged = 0;
    double outside_aperture = 0;
    double total_reflection = 0;
    double searched = 0; ///< part of `imaged`: pixels imaged only by the accurate search
};

/// The centre of the k-th of `count` pixels spread evenly over the film, 0 <= k < count: every
/// pixel if `count` is the film's number of pixels, else the points of a rank-1 lattice, whose step
/// does not match the lenses'. Continuous pixel coordinates.
Vec2 spread_pixel(const Film& film, int k, int count);

/// Maps the centres of at most `samples` pixels, spread evenly over the film.
Coverage coverage(const IntegralCamera& camera, int samples);

} // namespace integral

#endif
