// SPDX-License-Identifier: AGPL-3.0-or-later
// Converts the pitch of a sheet's lenses to the pitch, on the film, of their images of an eye, and
// back.
#ifndef INTEGRAL_OPTICS_VISUAL_PITCH_H
#define INTEGRAL_OPTICS_VISUAL_PITCH_H

#include "integral/optics/lens_sheet.h"

namespace integral {

/// The pitch, on the film, of the lenses' images of an eye at `distance`, a little more than the
/// lenses' own pitch: the mean from the axis to a lens `place` mm from the axis,
/// p (1 + t/sqrt(n^2 d^2 + (n^2 - 1) place^2)) (optics.md section 4).
double visual_pitch(double pitch, const LensSheet& sheet, double distance, double place = 0);

/// Inverse of visual_pitch: the lenses' own pitch.
double pitch_of_visual(double visual, const LensSheet& sheet, double distance, double place = 0);

} // namespace integral

#endif
