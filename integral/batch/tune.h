// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds the sampling settings for a scene: renders some bands of its frame at a ladder of settings,
// and predicts each one's error and time for the whole frame.
#ifndef INTEGRAL_BATCH_TUNE_H
#define INTEGRAL_BATCH_TUNE_H

#include "integral/base/parallel.h"
#include "integral/lightfield/error_estimate.h"

#include <optional>
#include <string>
#include <vector>

namespace integral {

/// What is wanted of the frame: the least time at an error, the least error in a time, or both
/// empty: the whole ladder is measured.
struct TuneGoal {
    std::optional<double> error;   ///< RMS, in the output encoding, 1 is full scale
    std::optional<double> seconds; ///< of the whole render by the clock
};

/// A setting, as it is added to a command line.
struct TuneSetting {
    std::string camera;               ///< the integral camera's words, for Integral_Camera
    std::vector<std::string> options; ///< of povray-integral: +A and what belongs to it
};

/// One rung of the ladder, as predicted for the whole frame.
struct TunePoint {
    TuneSetting setting;
    ErrorEstimate error;
    double seconds = 0;   ///< by the clock, parsing and the estimate of the error included
    double processor = 0; ///< the same, of all processors together
};

struct TuneResult {
    int width = 0, height = 0;     ///< pixels of the frame
    int rows = 0;                  ///< of them rendered at each setting
    double parsing = 0;            ///< seconds before the first ray, a part of each prediction
    std::vector<TunePoint> points; ///< from cheap to dear, in the order in which they were measured
    std::optional<std::size_t> best; ///< of points; empty: none reaches the goal
    /// The Integral_Camera= that the options have, "" if none: the setting's words go after it.
    std::string camera;
};

/// What an estimate counts for: its rms; the end of its interval if that begins at 0, as where the
/// few pixels that were looked at had no error by chance.
double counted_error(const ErrorEstimate& error);

/// The best of the points for a goal: the fastest within the error, the least error within the
/// seconds (of both goals: the fastest within both). Empty if there is none.
std::optional<std::size_t> best_point(const std::vector<TunePoint>& points, const TuneGoal& goal);

/// Measures a scene (.pov or .ini) with these further options of povray-integral, which have no +A.
/// `done` is called with the number of rendered pieces. Settings that cannot be the best any more
/// are not measured. Throws InputError where the scene cannot be rendered or is not integral,
/// std::invalid_argument for options that do not go with it, Interrupted.
TuneResult tune(const std::string& scene, const std::vector<std::string>& options,
                const TuneGoal& goal, const Progress& progress = {});

/// The words of povray-integral's command line that render the whole frame with a setting.
std::vector<std::string> tuned_words(const std::string& scene,
                                     const std::vector<std::string>& options,
                                     const TuneResult& result, const TuneSetting& setting);

/// The same with the program's name, for a shell.
std::string tuned_command(const std::string& scene, const std::vector<std::string>& options,
                          const TuneResult& result, const TuneSetting& setting);

} // namespace integral

#endif
