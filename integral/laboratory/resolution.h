// SPDX-License-Identifier: AGPL-3.0-or-later
// The resolution experiment of thesis 4.3.7: charts of bars in front of a sheet, rendered, replayed
// and measured. doc/resolution.md is its protocol.
#ifndef INTEGRAL_LABORATORY_RESOLUTION_H
#define INTEGRAL_LABORATORY_RESOLUTION_H

#include "integral/base/parallel.h"
#include "integral/frame/frame.h"

#include <string>
#include <vector>

namespace integral {

constexpr double resolved_modulation = 0.5; ///< least modulation of bars that count as resolved
                                            ///< (4.3.7)

struct ResolutionRequest {
    LensSheet sheet;                  ///< lenticular, without slant
    Vec2 pixel_pitch;                 ///< mm
    std::vector<double> frequencies;  ///< cycles (a bright and a dark bar) per mm
    std::vector<double> depths;       ///< mm in front of the sheet, 0 or more
    double observer = 400, pupil = 4; ///< mm; the aperture is at the observer's distance, too
    std::string camera_words = "pixel_samples 4 beam_samples 16"; ///< how the charts are rendered
};

/// Modulation (B - D)/(B + D) of one chart, for the mean lights B and D of the bright and dark
/// bars' middle thirds: 1 at best, below 0 where bars have changed places.
struct ResolutionCell {
    double screen = 0;   ///< on a diffusing screen at the chart's place
    double observer = 0; ///< for an eye that is focused on the chart
    /// On the screen, limited by lens and pixel alone: expected_modulation.
    double expected = 0;
};

/// Rows: depths; columns: frequencies.
using ResolutionTable = std::vector<std::vector<ResolutionCell>>;

/// Modulation, on the screen, of bars at a depth. It assumes that every pixel captures, and shows,
/// the mean over a beam as wide as the lens (p), blurred by the pixel's spread at that depth (s;
/// thesis 4-5): each harmonic of the bars is multiplied by (sinc(f p) sinc(f s))^2.
double expected_modulation(const ResolutionRequest& request, double frequency, double depth);

/// The scene that has all charts of a depth: a row of bars for each frequency.
std::string chart_scene(const ResolutionRequest& request, double depth);

/// Measures all charts of a depth in the frame of their scene.
std::vector<ResolutionCell> measured_charts(const ResolutionRequest& request, double depth,
                                            const Frame& frame, int threads);

/// Runs the whole experiment; povray-integral renders the charts. Throws InputError if it cannot,
/// Interrupted, std::invalid_argument for unsuitable sheets, depths and frequencies.
ResolutionTable measured_resolution(const ResolutionRequest& request, int threads,
                                    const Progress& progress);

} // namespace integral

#endif
