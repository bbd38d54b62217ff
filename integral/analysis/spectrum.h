// SPDX-License-Identifier: AGPL-3.0-or-later
// Computes the power spectrum of a raster of numbers, by FFTW.
#ifndef INTEGRAL_ANALYSIS_SPECTRUM_H
#define INTEGRAL_ANALYSIS_SPECTRUM_H

#include "integral/analysis/edge_response.h"
#include "integral/optics/vec.h"

namespace integral {

/// Power at each frequency, divided by the mean power at frequencies of about the same magnitude;
/// noise alone has about 1.
class Spectrum {
public:
    /// Takes at most `most` pixels each way from the plane's middle, less their mean, under a Hann
    /// window.
    Spectrum(const Plane& plane, int most);

    /// Power at a frequency in cycles per pixel along x and y (downwards), interpolated; 0 beyond
    /// half a cycle per pixel.
    double power(Vec2 frequency) const;

    int extent() const { return extent_; } ///< pixels of the shorter side of the window

private:
    int size_, extent_;
    std::vector<float> power_; ///< (size_/2 + 1) columns from frequency 0, size_ rows
};

} // namespace integral

#endif
