// SPDX-License-Identifier: AGPL-3.0-or-later
// Measures a lens sheet from one photograph of a calibration page that lies under it.
//
// The squares around the sheet give the camera; the beat bands give the phase of the lenses against
// the print at each place, and so pitch, turn and phase as the camera sees them; the coarse bands'
// displacement gives how much film the lenses show per angle, t/n. All are fitted together. What a
// photograph determines poorly is held by the nominal figures, with these standard deviations:
// thickness 2%, index 0.7%, and half the effect of a spherical surface.
#ifndef INTEGRAL_ANALYSIS_SHEET_CALIBRATION_H
#define INTEGRAL_ANALYSIS_SHEET_CALIBRATION_H

#include "integral/analysis/calibration_light.h"

namespace integral {

struct SheetCalibration {
    SheetView view;
    Estimate pitch; ///< mm
    Estimate turn;  ///< degrees, anticlockwise, from the nominal slant
    Estimate phase; ///< mm across the lenses, from the page's middle to the nearest axis
    /// Effective t/n, mm: what it would be if the lenses' poles alone imaged the film.
    Estimate thickness_over_index;
    /// The same as expected of the nominal sheet, with spherical surfaces.
    Estimate expected_thickness_over_index;
    Estimate distance; ///< mm, from the camera to the sheet's plane
    CalibrationLight light;
    int corners = 0, corners_of = 0; ///< used, and on the page
    int blocks = 0, blocks_of = 0;   ///< of beat bands: under the sheet, and on the page
    double corner_residual = 0;      ///< pixels, root mean square along x and y
    double phase_residual = 0;       ///< periods, root mean square
};

/// Throws std::invalid_argument, with advice, if the photo does not show such a page, or no such
/// sheet. `photo`: linear light.
SheetCalibration calibrate_sheet(const Plane& photo, const CalibrationPage& page, int threads);

} // namespace integral

#endif
