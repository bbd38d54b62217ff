// SPDX-License-Identifier: AGPL-3.0-or-later
// Predicts the sampling error of a frame before rendering, from the optics and a statistical model
// of the scene.
//
// The model scene is a plane parallel to the sheet at a given depth behind it. Straight edges at
// random positions and in random directions (a Poisson line process) divide the plane into black
// and white regions; the colour changes at each edge. Along any line the edges are `detail` mm
// apart on average. Two points at distance r have the same colour (black 0 or white 1) if the
// number of edges between them is even, so their covariance is C(r) = exp(-2 r/detail)/4.
//
// The reference value of a pixel is the mean over the plane's points f_j that the pixel's area sees
// through the lens's whole cell: the pixel's spread (4-5) at that depth, widened by the cell. The
// rendered value is the mean over the points x_i that its rays meet. The mean square of the
// difference, over all such scenes, is
//     mean C(|x_i - x_j|) - 2 mean C(|x_i - f_j|) + mean C(|f_i - f_j|).
// For orientation, consider points on a segment of length w. If w is short compared with `detail`,
// an edge crosses the segment with probability w/detail, at a uniformly distributed place. One ray
// through the middle is then wrong by the fraction of the segment on the edge's shorter side: mean
// square (w/detail)/12. Of N rays, each at random in its own N-th of the segment, only the ray
// whose part contains the edge can be wrong. With the edge at a fraction u of that part, it has the
// variance u(1 - u)/N^2: (w/detail)/(6 N^2) on average. The renderer's two independent halves of
// N/2 rays give (w/detail)/(3 N^2). If w is long compared with `detail`, the colours are
// uncorrelated: 1/4 for one ray.
#ifndef INTEGRAL_SHEET_SAMPLING_FORECAST_H
#define INTEGRAL_SHEET_SAMPLING_FORECAST_H

#include "integral/optics/camera.h"

#include <optional>
#include <vector>

namespace integral {

/// Sampling settings of the scene language, and the errors predicted for them.
struct SamplingForecast {
    int beam_samples = 1, pixel_samples = 1;
    std::vector<double> rms; ///< for each depth: root mean square error in linear light; 1 is the
                             ///< difference of black and white
    int rays() const { return beam_samples * pixel_samples; } ///< per pixel, at most
};

/// The settings for which reports show errors, from one ray per pixel to nearly converged: 1, 4, 4,
/// 16 and 64 rays.
std::vector<SamplingForecast> sampling_ladder();

/// Appends to the empty `rms` of each of `settings`, one error for each of `depths`, computed with
/// the renderer's sampler (pixel_sampler.h) for pixels behind the lens in the middle of the film.
/// `depths` and `detail` in mm, > 0. The camera's numbers of samples and its placement are ignored.
/// Returns false, and leaves `rms` empty, if for any of `settings` none of those pixels gets a ray.
bool forecast_errors(const IntegralCamera& camera, const std::vector<double>& depths, double detail,
                     std::vector<SamplingForecast>& settings);

} // namespace integral

#endif
