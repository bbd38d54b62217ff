// SPDX-License-Identifier: AGPL-3.0-or-later
// Where a batch keeps its things.
#ifndef INTEGRAL_BATCH_BATCH_FOLDER_H
#define INTEGRAL_BATCH_BATCH_FOLDER_H

#include "integral/batch/plan.h"
#include "integral/batch/step_record.h"

#include <string>

namespace integral {

/// Paths below the output folder.
struct BatchFolder {
    std::string path; ///< absolute

    std::string output(const BatchStep& step) const { return path + "/" + step.output; }
    std::string own() const { return path + "/.integral-batch"; }
    std::string record(const BatchStep& step) const
    {
        return own() + "/steps/" + step.name + ".json";
    }
    std::string lock(const std::string& name) const { return own() + "/locks/" + name; }
    /// The folder in which a step works; gone when it has ended.
    std::string work(const BatchStep& step) const { return own() + "/work/" + step.name; }
    /// What a step writes, before it becomes its output.
    std::string made(const BatchStep& step) const
    {
        return work(step) + "/made" + step.output.substr(step.output.rfind('.'));
    }
    /// All that a failed step's program said.
    std::string log(const BatchStep& step) const { return path + "/logs/" + step.name + ".txt"; }
};

/// The folder, made where it is missing, with those in it that the plan's outputs need. Throws
/// OutputError.
BatchFolder make_batch_folder(const std::string& output, const BatchPlan& plan);

/// The folder as it is.
BatchFolder batch_folder(const std::string& output);

/// Whether a step's output is there as its record says, made from these inputs. An output that is
/// whole but was not yet in its place when its batch was killed is put there.
bool is_done(const BatchFolder& folder, const BatchStep& step, const StepRecord& record,
             const std::string& inputs);

/// Puts what a step has made in its place, with its record: first the record, which tells the file
/// by its content, so that a kill between the two loses nothing. Fills in the record's output and
/// bytes. Throws OutputError.
void publish(const BatchFolder& folder, const BatchStep& step, StepRecord record);

/// Whether a picture has its last byte, as far as its format shows it: a disk may have been full.
/// Other formats: whether it is not empty.
bool is_whole(const std::string& path);

} // namespace integral

#endif
