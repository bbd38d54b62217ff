// SPDX-License-Identifier: AGPL-3.0-or-later
// What a batch keeps of each step, in a file of its own: OUTPUT/.integral-batch/steps/STEP.json.
#ifndef INTEGRAL_BATCH_STEP_RECORD_H
#define INTEGRAL_BATCH_STEP_RECORD_H

#include <optional>
#include <string>

namespace integral {

enum class StepState { none, running, done, failed };
const char* name_of(StepState state);

struct StepRecord {
    StepState state = StepState::none; ///< running: also where its batch was killed
    int starts = 0;                    ///< how often it was begun, in all
    std::string inputs;                ///< hash of what it took
    std::string output;                ///< hash of what it made; empty unless done
    double bytes = 0;                  ///< of the output
    double seconds = 0;                ///< of the last run, by the clock
    double memory = 0;                 ///< bytes, the most that its process had
    double pixels = 0;                 ///< of the frame
    double render_seconds = 0;         ///< of a frame, as it says itself
    std::optional<double> error;       ///< a frame's estimated RMS error
    std::string finished, host;        ///< when (UTC, ISO 8601) and where
    std::string reason;                ///< of the failure, one line
    std::string remark; ///< what its program said of the frame though it was done; one line, mostly
                        ///< empty
};

/// A record that is missing, or that is none (a broken disk's, another program's), reads as an
/// empty one.
StepRecord read_record(const std::string& path);

/// Writes it whole or not at all. Throws OutputError.
void write_record(const std::string& path, const StepRecord& record);

} // namespace integral

#endif
