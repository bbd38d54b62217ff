// SPDX-License-Identifier: AGPL-3.0-or-later
// The paths of a batch's files below its output folder, and how a step's output gets there.
#ifndef INTEGRAL_BATCH_BATCH_FOLDER_H
#define INTEGRAL_BATCH_BATCH_FOLDER_H

#include "integral/batch/plan.h"
#include "integral/batch/step_record.h"

#include <string>

namespace integral {

/// Paths below the output folder.
struct BatchFolder {
    std::string path; ///< absolute, of the output folder

    std::string output(const BatchStep& step) const { return path + "/" + step.output; }
    /// The folder of records, locks and unfinished work.
    std::string own() const { return path + "/.integral-batch"; }
    std::string record(const BatchStep& step) const
    {
        return own() + "/steps/" + step.name + ".json";
    }
    std::string lock(const std::string& name) const { return own() + "/locks/" + name; }
    /// The folder of a step's unfinished files; deleted when the step has ended.
    std::string work(const BatchStep& step) const { return own() + "/work/" + step.name; }
    /// What a step's program writes, before it is moved to the output's path.
    std::string made(const BatchStep& step) const
    {
        return work(step) + "/made" + step.output.substr(step.output.rfind('.'));
    }
    /// What the program of a step that failed has printed.
    std::string log(const BatchStep& step) const { return path + "/logs/" + step.name + ".txt"; }
};

/// Makes the output folder and the folders in it that the plan's outputs need, if they are missing.
/// Throws OutputError.
BatchFolder make_batch_folder(const std::string& output, const BatchPlan& plan);

/// The paths alone; nothing is made.
BatchFolder batch_folder(const std::string& output);

/// Whether a step's output is there, as its record describes it, and was made from inputs of the
/// hash `inputs`. An output that was whole but not yet in its place when its batch was killed is
/// moved there.
bool is_done(const BatchFolder& folder, const BatchStep& step, const StepRecord& record,
             const std::string& inputs);

/// Writes a step's record and moves what it has made to its output's path. The record, with the
/// hash of the file, is written first: if the batch is killed between the two, is_done finds the
/// file and moves it. Throws OutputError.
void publish(const BatchFolder& folder, const BatchStep& step, StepRecord record);

/// Whether a file was written to its end, which a full disk may have prevented: by the last chunk
/// of PNG and the table of OpenEXR; of other formats whether it is not empty.
bool is_whole(const std::string& path);

} // namespace integral

#endif
