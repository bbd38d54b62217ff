// SPDX-License-Identifier: AGPL-3.0-or-later
// Fits camera and sheet to a calibration page's corners and phases together, with errors.
#ifndef INTEGRAL_ANALYSIS_CALIBRATION_FIT_H
#define INTEGRAL_ANALYSIS_CALIBRATION_FIT_H

#include "integral/analysis/band_blocks.h"
#include "integral/analysis/least_squares.h"
#include "integral/analysis/page_corners.h"

namespace integral {

/// A measured phase.
struct PhasePoint {
    CalibrationBand band;
    Vec2 photo;
    double phase; ///< band_phase at that place, periods
};

/// The nominal sheet, and how much its figures are trusted: standard deviations, relative.
struct SheetPrior {
    double thickness = 0, ior = 0;
    SurfaceEffect surface; ///< of spherical lenses
    double thickness_error = 0.02, ior_error = 0.007;
    double surface_error = 0.5; ///< of the surface's effect
};

/// Parameters beyond the camera's, by their places in the fit.
enum SheetParameter : std::size_t {
    stretch_parameter = camera_parameters,
    pitch_parameter, ///< logarithm
    angle_parameter,
    phase_parameter,     ///< mm
    thickness_parameter, ///< logarithm of the true divided by the nominal one
    ior_parameter,       ///< the same
    surface_parameter,   ///< the surface's effect divided by that of spherical lenses, less 1
    fit_parameters
};

/// Sets a view's thickness, index and surface. `parameters`: all of a fit's.
void set_lenses(const SheetPrior& prior, const std::vector<double>& parameters, SheetView& view);

/// A figure and its standard deviation.
struct Estimate {
    double value = 0, deviation = 0;
};

struct CalibrationFit {
    SheetView view;
    SquareMatrix covariance{fit_parameters};
    Estimate reach;                                                      ///< effective_reach
    double corner_residual = 0, phase_residual = 0, coarse_residual = 0; ///< rms, pixels, periods
};

/// Fits all parameters; `start`: a view near the truth. Points far off the others count nothing.
/// The covariance is that of the scatter between parts of the page, plus what the priors leave
/// open: in turn, tiles, rows and columns of the page are taken as independent, and the
/// greatest variance of each parameter counts. Throws std::invalid_argument if too few points
/// remain.
CalibrationFit fit_calibration(const SheetView& start, const std::vector<PageCorner>& corners,
                               const std::vector<PhasePoint>& phases, const SheetPrior& prior,
                               Vec2 photo_size);

} // namespace integral

#endif
