// SPDX-License-Identifier: AGPL-3.0-or-later
// Estimates the error of a rendered frame against its converged 4-D reference, from additional
// samples of some pixels or from the frame's own samples.
#ifndef INTEGRAL_FRAME_ERROR_ESTIMATE_H
#define INTEGRAL_FRAME_ERROR_ESTIMATE_H

#include "integral/frame/encoding.h"

#include <array>
#include <optional>
#include <vector>

namespace integral {

/// A pixel's red, green and blue as the renderer computes them, usually in linear light.
using Light = std::array<double, 3>;

/// Converts the renderer's values to the picture file's.
struct OutputCurve {
    Encoding working{Encoding::Kind::linear}; ///< of the renderer's values (assumed_gamma)
    Encoding file;
    double operator()(double value) const; ///< `value` is first clamped to 0..1; NaN counts as 0
};

/// How the error was estimated.
enum class ErrorMethod {
    audit,       ///< from a random subset of the lit pixels (those that a lens images),
                 ///< each rendered again with independent samples of area and cell
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

/// The squared error of one rendered pixel, averaged over its channels: |encoded pixel -
/// estimate|^2 minus the estimate's variance, so that the result can be below 0. `a` and `b` are
/// two independent estimates of the pixel's true light, from equally many samples. The estimate is
/// the mean of `a` and `b`, encoded and corrected for the bias from the encoding's curvature (the
/// jackknife); its variance comes from their difference. Values are clamped to 0..1. The result is
/// always finite.
double audited_error(const OutputCurve& curve, const Light& pixel, const Light& a, const Light& b);

/// The squared error of the mean m of two independent estimates of a pixel's light: `a` from
/// `first` samples and `b` from `second` samples. The result is the variance of the two encoded
/// halves about the encoded mean,
///     (first |a - m|^2 + second |b - m|^2)/(first + second),
///     m = (first a + second b)/(first + second).
/// Unbiased where the encoding is linear. For black and white edges and at least 16 samples, the
/// bias is at most 10% with PixelSampler's samples and 20% with independent samples. Always finite.
double halves_error(const OutputCurve& curve, const Light& a, const Light& b, int first,
                    int second);

/// Sums over pixels' squared errors, from which estimate() computes the mean and its variance. Each
/// thread can have its own ErrorSums, to be added at the end.
struct ErrorSums {
    long long pixels = 0;
    double sum = 0, sum_of_squares = 0;
    double largest = 0; ///< the largest squared error; 0 if it is not recorded
    void add(double squared_error);
    void add(const ErrorSums& other);
};

/// The bias that the estimators have at hard edges, as a fraction of the mean square.
constexpr double bias_at_edges = 0.1;

/// Sets rms, its interval, the method and the number of pixels; the caller sets the other fields.
/// Returns nothing for fewer than 2 pixels.
///
/// The mean of few pixels' squared errors may be near 0 or below by chance, but a frame's mean
/// square is never below 0. So rms is the square root of the posterior mean, given that the mean
/// square is non-negative. If the pixels' mean is at least 3 standard errors above 0, it differs
/// from the posterior mean by less than 0.2%.
///
/// The interval's upper bound comes from the central limit theorem in the logarithm of the mean
/// square or, if the mean square's relative error is large, in the mean square itself. The lower
/// bound is 0, or that of a sum of equal errors whose number is random (Poisson's distribution),
/// with the same relative error: most of a frame's error is in few pixels, and a set of pixels that
/// by chance contains more of these overestimates the error. The interval is widened
/// - upwards, as if one more pixel had the largest error: most of a frame's error is in few pixels,
///   a small set of pixels tends to miss these, and then underestimates the variance as well;
/// - for split halves, by the variance of the true error about its expectation;
/// - by `unsure`, the fraction of the mean square by which all pixels' squared errors may be wrong
///   in the same direction.
/// The interval does not account for errors that may be missed entirely, because so few of the
/// frame's pixels have them that `pixels` random pixels contain about 3 or fewer of these.
std::optional<ErrorEstimate> estimate(const ErrorSums& sums, ErrorMethod method,
                                      double unsure = bias_at_edges);

/// Adds another, independent error of the same frame: the squares of rms and of both bounds are
/// added. The interval becomes wider than necessary.
void add_independent(ErrorEstimate& error, const ErrorEstimate& other);

} // namespace integral

#endif
