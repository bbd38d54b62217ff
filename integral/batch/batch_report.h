// SPDX-License-Identifier: AGPL-3.0-or-later
// What a batch has done, for programs (summary.json) and for people (index.html).
#ifndef INTEGRAL_BATCH_BATCH_REPORT_H
#define INTEGRAL_BATCH_BATCH_REPORT_H

#include "integral/batch/batch_run.h"

#include <nlohmann/json_fwd.hpp>

namespace integral {

/// What became of the jobs: states, seconds, errors, files, from the results and the steps'
/// records. `jobs` as in RunOptions.
nlohmann::ordered_json batch_summary(const Manifest& manifest, const BatchPlan& plan,
                                     const std::vector<StepResult>& results,
                                     const std::set<int>& jobs);

/// A page without any file beside it but the outputs that it links: a picture and the figures of
/// each job.
std::string batch_page(const nlohmann::ordered_json& summary, const BatchFolder& folder);

} // namespace integral

#endif
