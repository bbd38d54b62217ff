// SPDX-License-Identifier: AGPL-3.0-or-later
// The error that sampling will leave in a frame, foretold from the optics and a statistical
// picture, before rendering.
//
// The picture: a plane at a depth behind the sheet, parallel to it, crossed by straight edges at
// random places and in random directions (a Poisson process of lines), black on one side of each
// and white on the other. Along any line the edges are `detail` mm apart on average. Two of its
// points at distance r are alike in colour, black 0 or white 1, but for an even number of edges
// between them: their covariance is C(r) = exp(-2 r/detail)/4.
//
// A pixel should be the picture's mean over the plane's points that its area sees through its
// lens's whole cell: the pixel's spread (4-5) at that depth, widened by the cell. It is the mean
// over the points x_i that its rays meet. The mean square of the difference is, over all such
// pictures and with f_j for the points of the whole,
//     mean C(|x_i - x_j|) - 2 mean C(|x_i - f_j|) + mean C(|f_i - f_j|).
// In a row of points w long and short against `detail` there is an edge with probability w/detail,
// anywhere alike. One ray through the middle is then wrong by the part of the row on the edge's
// shorter side, at most a half: (w/detail)/12. Of N rays, each at random in its own N-th, only the
// one with the edge can be wrong, by 1/N, with the variance u(1 - u) of a toss: (w/detail)/(6 N^2);
// the renderer's two independent halves of N/2 make that (w/detail)/(3 N^2). In a long row, points
// of the picture have nothing in common: 1/4 for one ray.
#ifndef INTEGRAL_LIGHTFIELD_SAMPLING_FORECAST_H
#define INTEGRAL_LIGHTFIELD_SAMPLING_FORECAST_H

#include "integral/optics/camera.h"

#include <optional>
#include <vector>

namespace integral {

/// Settings of the scene language, and what they are foretold to leave.
struct SamplingForecast {
    int beam_samples = 1, pixel_samples = 1;
    std::vector<double> rms; ///< for each depth: root mean square error in linear light, 1 = black
                             ///< against white
    int rays() const { return beam_samples * pixel_samples; } ///< a lit pixel, at most
};

/// The steps from one ray a pixel to the converged frame that users are shown: 1, 4, 4, 16 and 64
/// rays.
std::vector<SamplingForecast> sampling_ladder();

/// Fills in the empty `rms` of each of `settings`, for pixels behind the lens in the middle of
/// `camera`'s film and by the renderer's own sampler (pixel_sampler.h). `depths` and `detail` in
/// mm, > 0. The camera's own samples and its placement do not count. False, with rms left empty,
/// where none of those pixels images anything.
bool forecast_errors(const IntegralCamera& camera, const std::vector<double>& depths, double detail,
                     std::vector<SamplingForecast>& settings);

} // namespace integral

#endif
