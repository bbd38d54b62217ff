// SPDX-License-Identifier: AGPL-3.0-or-later
// The filters of FLIP, and the exposures of HDR-FLIP: Andersson and others, "FLIP: A Difference
// Evaluator for Alternating Images" (2020), and Andersson and others, "Visualizing Errors in
// Rendered High Dynamic Range Images" (2021). Equation numbers below are the first paper's.
#ifndef INTEGRAL_COMPARE_FLIP_KERNELS_H
#define INTEGRAL_COMPARE_FLIP_KERNELS_H

#include <cstdint>
#include <vector>

namespace integral {

/// A filter along a row or a column: values[radius + i] weighs the pixel at offset i.
struct FlipTaps {
    int radius = 0;
    std::vector<float> values;
};

/// Contrast sensitivity of the eye as separable filters, each of sum 1 in two dimensions, and the
/// detectors of edges and points. Two-dimensional filters are products of the one-dimensional ones.
struct FlipKernels {
    FlipTaps luminance, red_green;
    /// The filter of blue and yellow is the sum of two products: each of these with itself.
    FlipTaps blue_yellow[2];
    FlipTaps smooth;      ///< Gaussian, across the direction of a detector
    FlipTaps edge, point; ///< derivatives of `smooth`; positive weights add up to 1, negative to -1
    int radius = 0;       ///< the greatest radius of these filters
};

/// The default of FLIP's authors: 3840 pixels on 0.7 m, seen from 0.7 m.
constexpr double flip_default_ppd = 0.7 * 3840 / 0.7 * 3.14159265358979323846 / 180;

/// The kernels for a picture seen at `ppd` pixels per degree, > 0.
FlipKernels flip_kernels(double ppd);

/// HDR-FLIP compares the pictures at `count` exposures from `start` to `stop`, in stops, at equal
/// steps, tone mapped.
struct FlipExposures {
    double start = 0, stop = 0;
    int count = 0;
    double at(int index) const;
};

/// Finds the exposures for a reference picture from its luminances. At the first exposure the
/// greatest luminance is shown at 0.85 of full scale, at the last the median.
class FlipExposureMeter {
public:
    FlipExposureMeter();
    /// Takes a pixel's luminance. Values that are not finite or are below 0 count as 0.
    void add(float luminance);
    /// If more than half of the luminances are 0, uses the median of those above 0. If none is
    /// above 0, returns one exposure of 0 stops.
    FlipExposures exposures() const;

private:
    std::vector<std::uint32_t> counts_; ///< by the luminance's upper bits
    std::uint64_t dark_ = 0, bright_ = 0;
    float greatest_ = 0;
};

/// Matrices between linear sRGB and CIE XYZ relative to white. relative_from_rgb has the rows X, Y,
/// Z; its inverse, rgb_from_relative, has R, G, B.
struct FlipMatrices {
    double relative_from_rgb[3][3], rgb_from_relative[3][3];
};
const FlipMatrices& flip_matrices();

} // namespace integral

#endif
