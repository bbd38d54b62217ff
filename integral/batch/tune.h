// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds the sampling settings for a scene: renders some bands of its frame at a ladder of settings,
// and predicts each setting's error and time for the whole frame.
#ifndef INTEGRAL_BATCH_TUNE_H
#define INTEGRAL_BATCH_TUNE_H

#include "integral/base/parallel.h"
#include "integral/frame/error_estimate.h"

#include <optional>
#include <string>
#include <vector>

namespace integral {

/// Goal for the frame: least time at an error, least error in a time, or the fastest within both.
/// If both are empty, the whole ladder is measured.
struct TuneGoal {
    std::optional<double> error;   ///< RMS, in the output encoding, 1 is full scale
    std::optional<double> seconds; ///< of the whole render by the clock
};

/// A setting, to be added to a command line.
struct TuneSetting {
    std::string camera;               ///< the integral camera's words, for Integral_Camera
    std::vector<std::string> options; ///< of povray-integral: +A and its companions
};

/// One rung of the ladder, as predicted for the whole frame.
struct TunePoint {
    TuneSetting setting;
    ErrorEstimate error;
    double seconds = 0;   ///< by the clock, including parsing and the estimate of the error
    double processor = 0; ///< the same, of all processors together
};

struct TuneResult {
    int width = 0, height = 0;       ///< pixels of the frame
    int rows = 0;                    ///< of the frame, rendered at each setting
    double parsing = 0;              ///< seconds before the first ray, a part of each prediction
    std::vector<TunePoint> points;   ///< from cheap to expensive, in the order of measurement
    std::optional<std::size_t> best; ///< index of a point; empty: no point reaches the goal
    /// The Integral_Camera= among the options, "" if none; the setting's words follow it.
    std::string camera;
};

/// The error by which an estimate is judged: its rms; or the upper end of its interval if the lower
/// end is 0, e.g. because the few audited pixels had no error by chance.
double counted_error(const ErrorEstimate& error);

/// The best of the points for a goal: the fastest within the error, the least error within the
/// seconds, or the fastest within both. Empty if there is none.
std::optional<std::size_t> best_point(const std::vector<TunePoint>& points, const TuneGoal& goal);

/// Measures a scene (.pov or .ini) with further options of povray-integral, which must not contain
/// +A. `progress` counts rendered bands. Skips settings that can no longer be the best. Throws
/// InputError if the scene cannot be rendered or is not integral, std::invalid_argument for options
/// that tune cannot use, Interrupted.
TuneResult tune(const std::string& scene, const std::vector<std::string>& options,
                const TuneGoal& goal, const Progress& progress = {});

/// The words of povray-integral's command line that render the whole frame at a setting.
std::vector<std::string> tuned_words(const std::string& scene,
                                     const std::vector<std::string>& options,
                                     const TuneResult& result, const TuneSetting& setting);

/// tuned_words with the program's name, for a shell.
std::string tuned_command(const std::string& scene, const std::vector<std::string>& options,
                          const TuneResult& result, const TuneSetting& setting);

} // namespace integral

#endif
