// SPDX-License-Identifier: AGPL-3.0-or-later
// The paths of a batch's files below its output folder, and how a step's output gets there.
#ifndef INTEGRAL_BATCH_BATCH_FOLDER_H
#define INTEGRAL_BATCH_BATCH_FOLDER_H

#include "integral/batch/plan.h"
#include "integral/batch/step_record.h"

#include <string>

namespace integral {

/// Builds the paths below the output folder.
struct BatchFolder {
    std::string path; ///< the output folder, absolute

    std::string output(const BatchStep& step) const { return path + "/" + step.output; }
    /// The folder of records, locks and unfinished work.
    std::string own() const { return path + "/.integral-batch"; }
    std::string record(const BatchStep& step) const
    {
        return own() + "/steps/" + step.name + ".json";
    }
    std::string lock(const std::string& name) const { return own() + "/locks/" + name; }
    /// The folder of a step's unfinished files; deleted after the step's end.
    std::string work(const BatchStep& step) const { return own() + "/work/" + step.name; }
    /// The path where a step's program writes; publish() moves the file to the output's path.
    std::string made(const BatchStep& step) const
    {
        return work(step) + "/made" + step.output.substr(step.output.rfind('.'));
    }
    /// The copy of what a failed step's program printed.
    std::string log(const BatchStep& step) const { return path + "/logs/" + step.name + ".txt"; }
};

/// Makes the output folder and its subfolders for the plan's outputs, unless they exist. Throws
/// OutputError.
BatchFolder make_batch_folder(const std::string& output, const BatchPlan& plan);

/// Builds the paths without making any folder.
BatchFolder batch_folder(const std::string& output);

/// Whether a step's output exists, has the hash in its record, and was made from inputs with the
/// hash `inputs`. Moves a finished output into place if its batch was killed just before that.
bool is_done(const BatchFolder& folder, const BatchStep& step, const StepRecord& record,
             const std::string& inputs);

/// Writes a step's record, then moves the step's result to the output's path. The record, with the
/// file's hash, comes first: if the batch is killed before the move, is_done moves the file. Throws
/// OutputError.
void publish(const BatchFolder& folder, const BatchStep& step, StepRecord record);

/// Whether a file was written to its end: a full disk may cut it short. Checks the last chunk of
/// PNG and the table of OpenEXR; a file of another format passes unless it is empty.
bool is_whole(const std::string& path);

} // namespace integral

#endif
