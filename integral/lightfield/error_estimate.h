// SPDX-License-Identifier: AGPL-3.0-or-later
// Estimates the error of a rendered frame against its converged 4-D reference from a few additional
// samples.
#ifndef INTEGRAL_LIGHTFIELD_ERROR_ESTIMATE_H
#define INTEGRAL_LIGHTFIELD_ERROR_ESTIMATE_H

#include "integral/lightfield/encoding.h"

#include <array>
#include <optional>
#include <vector>

namespace integral {

/// A pixel's red, green and blue as the renderer computes them, usually in linear light.
using Light = std::array<double, 3>;

/// Converts the renderer's values to those of the picture file.
struct OutputCurve {
    Encoding working{Encoding::Kind::linear}; ///< of the renderer's values (assumed_gamma)
    Encoding file;
    double operator()(double value) const; ///< `value` is first clamped to 0..1; NaN counts as 0
};

/// How the error was estimated.
enum class ErrorMethod {
    audit,       ///< from a random subset of the lit pixels, each rendered again with independent
                 ///< samples of pixel area and lens cell
    split_halves ///< from every lit pixel's own samples, as the difference of two independent
                 ///< halves
};

/// An estimated error: root mean square over red, green and blue of the lit pixels, in the output
/// encoding (1 = full scale).
struct ErrorEstimate {
    double rms = 0;
    double low = 0,
           high = 0; ///< the interval that contains the true error with probability `confidence`
    double confidence = 0.95;
    ErrorMethod method = ErrorMethod::audit;
    long long pixels = 0;     ///< number of lit pixels that were examined
    long long lit_pixels = 0; ///< number of lit pixels in the frame
    int samples = 0;          ///< rays or beams per examined pixel
    double seconds = 0;       ///< run time of the estimate, in addition to rendering
};

/// The squared error of one rendered pixel, averaged over its channels. `a` and `b` are two
/// independent estimates of the pixel's true light, from equally many samples. The result is
/// |encoded pixel - estimate|^2 less the estimate's variance, which the difference of the two
/// tells; the estimate is that of the two together, less the bias from the encoding's curvature
/// (the jackknife). So the result can be below 0. Values are clamped to 0..1. The result is always
/// finite.
double audited_error(const OutputCurve& curve, const Light& pixel, const Light& a, const Light& b);

/// The squared error of the mean m of two independent estimates of a pixel's light: `a` from
/// `first` samples and `b` from `second` samples. It is the variance of the two encoded halves
/// about the encoded mean,
///     (first |a - m|^2 + second |b - m|^2)/(first + second),
///     m = (first a + second b)/(first + second).
/// Unbiased where the encoding is linear. For black and white edges and at least 16 samples it is
/// within 10% for PixelSampler's samples, within 20% for independent samples. Always finite.
double halves_error(const OutputCurve& curve, const Light& a, const Light& b, int first,
                    int second);

/// Sums over pixels' squared errors, from which estimate() computes the mean and its variance. Each
/// thread can have its own, to be added at the end.
struct ErrorSums {
    long long pixels = 0;
    double sum = 0, sum_of_squares = 0;
    double largest = 0; ///< the largest squared error; 0 if it is not recorded
    void add(double squared_error);
    void add(const ErrorSums& other);
};

/// The bias that the estimators have at hard edges, as a part of the mean square.
constexpr double bias_at_edges = 0.1;

/// Sets rms, its interval, the method and the number of pixels; the caller sets the other fields.
/// Returns nothing for fewer than 2 pixels.
///
/// The mean of few pixels' squared errors may be near 0 or below by chance, where a frame's cannot
/// be. So rms is the root of the value expected of a frame's mean that is not below 0. From 3
/// standard errors on, that differs from the pixels' mean by less than 0.2%.
///
/// The interval's upper bound is that of the central limit theorem in the logarithm of the mean
/// square, or in the mean square itself if its relative error is large. Its lower bound is that of
/// a sum of a random number of alike errors (Poisson's distribution) with the same relative error,
/// or 0: most of a frame's error is in few pixels, and a sample that happens to have more of them
/// tells too large an error. The interval is widened
/// - upwards, as if one more pixel had the largest error: most of a frame's error is in few pixels,
///   a small sample tends to miss them, and then it underestimates the variance as well;
/// - for split halves, by the variance of the true error about its expectation;
/// - by `unsure`, the part of the mean square by which all pixels' squared errors may be wrong
///   alike.
/// Errors in so few pixels that about 3 or fewer of `pixels` random pixels would have them may be
/// missed entirely; the interval does not account for them.
std::optional<ErrorEstimate> estimate(const ErrorSums& sums, ErrorMethod method,
                                      double unsure = bias_at_edges);

/// Adds another error of the same frame, which is independent of this one: their squares are added.
/// So are those of the bounds, which makes the interval wider than it need be.
void add_independent(ErrorEstimate& error, const ErrorEstimate& other);

} // namespace integral

#endif
