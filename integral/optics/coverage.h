// SPDX-License-Identifier: AGPL-3.0-or-later
// How much of its film a camera images, and why the rest stays empty.
#ifndef INTEGRAL_OPTICS_COVERAGE_H
#define INTEGRAL_OPTICS_COVERAGE_H

#include "integral/optics/camera.h"

namespace integral {

/// Fractions of the film's pixels, 0 to 1. The first three add up to 1.
struct Coverage {
    double imaged = 0;
    double outside_aperture = 0;
    double total_reflection = 0;
    double searched = 0; ///< part of `imaged`: pixels that only the accurate search images
};

/// Maps the centres of at most `samples` pixels, spread evenly over the film.
Coverage coverage(const IntegralCamera& camera, int samples);

} // namespace integral

#endif
