// SPDX-License-Identifier: AGPL-3.0-or-later
// The outcome of a batch as JUnit's XML, for CI systems.
#ifndef INTEGRAL_BATCH_BATCH_JUNIT_H
#define INTEGRAL_BATCH_BATCH_JUNIT_H

#include "integral/batch/planned_batch.h"

#include <nlohmann/json_fwd.hpp>

namespace integral {

/// A test case for each step in the summary (batch_summary), grouped by job. A failed step contains
/// its reason and the end of its program's log; a step whose frame failed, or that was not yet
/// made, is skipped. Jobs with Integral_Metadata=repeatable, or all if SOURCE_DATE_EPOCH is set,
/// have no seconds and no log, so that the document repeats.
std::string batch_junit(const PlannedBatch& batch, const nlohmann::ordered_json& summary);

} // namespace integral

#endif
