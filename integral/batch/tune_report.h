// SPDX-License-Identifier: AGPL-3.0-or-later
// The report of `integral tune`.
#ifndef INTEGRAL_BATCH_TUNE_REPORT_H
#define INTEGRAL_BATCH_TUNE_REPORT_H

#include "integral/batch/tune.h"
#include "integral/io/plot.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace integral {

/// The measured settings with error and predicted seconds, and the command line of the best one.
std::string tune_text(const std::string& scene, const std::vector<std::string>& options,
                      const TuneGoal& goal, const TuneResult& result);

/// The figures of tune_text as JSON.
nlohmann::ordered_json tune_json(const std::string& scene, const std::vector<std::string>& options,
                                 const TuneGoal& goal, const TuneResult& result);

/// The points as comma-separated values, for spreadsheets and NumPy: a line of names, then a line
/// for each setting; errors are RMS, 1 is full scale.
std::string tune_csv(const TuneResult& result);

/// Error against seconds, both logarithmic.
Plot tune_plot(const std::string& scene, const TuneResult& result);

} // namespace integral

#endif
