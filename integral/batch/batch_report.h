// SPDX-License-Identifier: AGPL-3.0-or-later
// Reports of a batch: for programs (summary.json), for people (index.html) and for a terminal.
#ifndef INTEGRAL_BATCH_BATCH_REPORT_H
#define INTEGRAL_BATCH_BATCH_REPORT_H

#include "integral/batch/batch_run.h"

#include <nlohmann/json_fwd.hpp>

namespace integral {

/// Summary of the jobs (states, seconds, errors, files) from the results and the steps' records.
/// Covers only `jobs`, or all if that is empty.
nlohmann::ordered_json batch_summary(const Manifest& manifest, const BatchPlan& plan,
                                     const std::vector<StepResult>& results,
                                     const std::set<int>& jobs);

/// A page with a picture and the figures of each job. It needs no other files than the outputs to
/// which it links.
std::string batch_page(const nlohmann::ordered_json& summary, const BatchFolder& folder);

/// Writes summary.json and index.html. Throws OutputError.
void write_summary(const BatchFolder& folder, const nlohmann::ordered_json& summary);

/// The plan as text, from a summary made without a run: one line per step, to do or kept.
std::string plan_text(const nlohmann::ordered_json& summary);

/// One line: the numbers of jobs done and failed and of steps made and kept. `with_missing`: also
/// the number of jobs not yet made.
std::string result_text(const nlohmann::ordered_json& summary, bool with_missing);

/// Prints the jobs that a cluster has not made to standard error, with the reasons. Returns whether
/// there are such jobs.
bool say_what_is_left(const nlohmann::ordered_json& summary);

} // namespace integral

#endif
