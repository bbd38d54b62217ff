// SPDX-License-Identifier: AGPL-3.0-or-later
// Reports the outcome of a batch as JUnit XML, for CI systems.
#ifndef INTEGRAL_BATCH_BATCH_JUNIT_H
#define INTEGRAL_BATCH_BATCH_JUNIT_H

#include "integral/batch/planned_batch.h"

#include <nlohmann/json_fwd.hpp>

namespace integral {

/// Makes a test case of each step in the summary (batch_summary), grouped by job. A failed step's
/// case has the reason and the end of the program's log. A step not yet made, or whose frame
/// failed, is skipped. Jobs with Integral_Metadata=repeatable, or all jobs if SOURCE_DATE_EPOCH is
/// set, have no seconds and no log, so that repeated runs give the same document.
std::string batch_junit(const PlannedBatch& batch, const nlohmann::ordered_json& summary);

} // namespace integral

#endif
