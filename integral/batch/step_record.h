// SPDX-License-Identifier: AGPL-3.0-or-later
// The record of a step's last run, a file for each: OUTPUT/.integral-batch/steps/STEP.json.
#ifndef INTEGRAL_BATCH_STEP_RECORD_H
#define INTEGRAL_BATCH_STEP_RECORD_H

#include <optional>
#include <string>

namespace integral {

enum class StepState { none, running, done, failed };
const char* name_of(StepState state);

struct StepRecord {
    StepState state = StepState::none; ///< stays `running` if its batch was killed
    int starts = 0;                    ///< number of starts, in all
    std::string inputs;                ///< hash of its inputs
    std::string output;                ///< hash of its output; empty unless done
    double bytes = 0;                  ///< size of the output
    double seconds = 0;                ///< of the last run, by the clock
    double memory = 0;                 ///< maximum of its process, bytes
    double pixels = 0;                 ///< of the frame
    double render_seconds = 0;         ///< of a frame, by its metadata
    std::optional<double> error;       ///< a frame's estimated RMS error
    std::string finished, host;        ///< when (UTC, ISO 8601) and where
    std::string reason;                ///< of the failure, one line
    std::string remark; ///< a warning about the frame, from a step that succeeded; one line,
                        ///< mostly empty
};

/// Reads a record; returns an empty one if the file is missing or holds no record.
StepRecord read_record(const std::string& path);

/// Writes a record atomically. Throws OutputError.
void write_record(const std::string& path, const StepRecord& record);

} // namespace integral

#endif
