// SPDX-License-Identifier: AGPL-3.0-or-later
// The starting order of a batch's steps, and the number of threads for each.
#ifndef INTEGRAL_BATCH_BATCH_SCHEDULE_H
#define INTEGRAL_BATCH_BATCH_SCHEDULE_H

#include "integral/batch/batch_folder.h"

#include <list>

namespace integral {

/// Sorts steps of the plan (indices) by starting order: first those that read a frame, then the
/// frames, longest first, by the seconds of their last run or else by their pixels. Thus the last
/// steps end at nearly the same time.
void sort_longest_first(std::list<int>& steps, const BatchPlan& plan, const BatchFolder& folder);

/// Number of threads for a step that starts when `others` more steps could start: `at_once`, the
/// number of concurrent programs, divided by the number of all these steps, rounded up.
int threads_beside(int others, int at_once);

} // namespace integral

#endif
