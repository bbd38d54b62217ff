// SPDX-License-Identifier: AGPL-3.0-or-later
// The error of a rendered frame against its converged 4-D reference, estimated from a few samples
// more.
#ifndef INTEGRAL_LIGHTFIELD_ERROR_ESTIMATE_H
#define INTEGRAL_LIGHTFIELD_ERROR_ESTIMATE_H

#include "integral/lightfield/encoding.h"

#include <array>
#include <optional>
#include <vector>

namespace integral {

/// A pixel as the renderer adds it up: red, green, blue, mostly linear light.
using Light = std::array<double, 3>;

/// From the renderer's values to those of the picture file.
struct OutputCurve {
    Encoding working{Encoding::Kind::linear}; ///< of the renderer's own values (POV-Ray's
                                              ///< assumed_gamma)
    Encoding file;
    double operator()(double value) const; ///< cut to 0..1, as a picture's values are; NaN counts
                                           ///< as 0
};

/// How the error was found.
enum class ErrorMethod {
    audit, ///< a random part of the lit pixels rendered anew, at independent samples of pixel area
           ///< and lens cell
    split_halves ///< every lit pixel's own samples, held against each other in two independent
                 ///< halves
};

/// An estimated error: root mean square over red, green and blue of the lit pixels, in the output
/// encoding (1 = full scale).
struct ErrorEstimate {
    double rms = 0;
    double low = 0,
           high = 0; ///< the interval that holds the true error with probability `confidence`
    double confidence = 0.95;
    ErrorMethod method = ErrorMethod::audit;
    long long pixels = 0;     ///< that were looked at
    long long lit_pixels = 0; ///< of these many
    int samples = 0;          ///< rays or beams that each of them was judged by
    double seconds = 0;       ///< that it took beside the rendering
};

/// The squared error of one rendered pixel, mean over its channels, from at least 2 independent
/// samples of the light that it ought to have: |encoded pixel - encoded mean of the samples|^2,
/// freed by the jackknife of what the samples' own scatter and the encoding's curvature add.
/// Unbiased up to terms of order 1/samples^2, and so below 0 now and then. Values are cut to 0..1
/// as a picture's are. Always finite.
double audited_error(const OutputCurve& curve, const Light& pixel,
                     const std::vector<Light>& samples);

/// The squared error of the mean m of two independent estimates a and b of a pixel's light, from
/// `first` and `second` samples each: the scatter of the encoded halves about the encoded m,
///     (first |a - m|^2 + second |b - m|^2)/(first + second),    m = (first a + second b)/(first +
///     second).
/// Unbiased where the encoding is straight. For black and white edges, with 16 samples and more:
/// within 10% as PixelSampler spreads them, 20% if each sample is independent. Always finite.
double halves_error(const OutputCurve& curve, const Light& a, const Light& b, int first,
                    int second);

/// Sums of pixels' squared errors: what the mean and its scatter need. May be added up from several
/// threads' shares.
struct ErrorSums {
    long long pixels = 0;
    double sum = 0, sum_of_squares = 0;
    double largest = 0; ///< of the squared errors; 0: not kept
    void add(double squared_error);
    void add(const ErrorSums& other);
};

/// The estimate from the pixels' squared errors: rms, its interval and the number of pixels; the
/// other fields are the caller's. Nothing of fewer than 2 pixels.
///
/// The interval is the central limit theorem's, symmetric in the logarithm of the mean square where
/// that is known well enough. It is widened
/// - upwards, as if the largest error had been met once more: most of a frame's error is in few
/// pixels, of which a
///   small sample meets too few rather than too many, and then the scatter looks too small as well;
/// - for halves, by the scatter of the true error about its own expectation;
/// - by the bias that the estimators keep with hard edges, 10% of the mean square.
/// Errors that fewer than about 3 of `pixels` pixels have may be met by none; nothing here can know
/// of them.
std::optional<ErrorEstimate> estimate(const ErrorSums& sums, ErrorMethod method);

} // namespace integral

#endif
