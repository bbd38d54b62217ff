// SPDX-License-Identifier: AGPL-3.0-or-later
// Reports of a batch: for programs (summary.json), for people (index.html) and for a terminal.
#ifndef INTEGRAL_BATCH_BATCH_REPORT_H
#define INTEGRAL_BATCH_BATCH_REPORT_H

#include "integral/batch/batch_run.h"

#include <nlohmann/json_fwd.hpp>

namespace integral {

/// What became of the jobs: states, seconds, errors, files, from the results and the steps'
/// records. Only of `jobs`, or of all if there are none in it.
nlohmann::ordered_json batch_summary(const Manifest& manifest, const BatchPlan& plan,
                                     const std::vector<StepResult>& results,
                                     const std::set<int>& jobs);

/// A page with a picture and the figures of each job. It needs no other file but the outputs that
/// it links.
std::string batch_page(const nlohmann::ordered_json& summary, const BatchFolder& folder);

/// Writes summary.json and index.html. Throws OutputError.
void write_summary(const BatchFolder& folder, const nlohmann::ordered_json& summary);

/// The plan that a summary without a run shows: a line for each step, to do or kept.
std::string plan_text(const nlohmann::ordered_json& summary);

/// One line: how many jobs are done and failed, and how many steps were made and kept.
/// `with_missing`: also how many jobs are not yet made.
std::string result_text(const nlohmann::ordered_json& summary, bool with_missing);

/// Says on standard error which jobs a cluster has not made, and why. Returns whether there are
/// any.
bool say_what_is_left(const nlohmann::ordered_json& summary);

} // namespace integral

#endif
