// SPDX-License-Identifier: AGPL-3.0-or-later
// The order in which a batch's steps start, and the threads that each one gets.
#ifndef INTEGRAL_BATCH_BATCH_SCHEDULE_H
#define INTEGRAL_BATCH_BATCH_SCHEDULE_H

#include "integral/batch/batch_folder.h"

#include <list>

namespace integral {

/// Sorts steps of the plan (indices) by the order in which they are to start: first those that read
/// a frame, then the frames, the longest first, by the seconds of their last run or by their
/// pixels. So the last ones end at nearly the same time.
void sort_longest_first(std::list<int>& steps, const BatchPlan& plan, const BatchFolder& folder);

/// The threads of a step that starts when `others` more could start as well: one if these are
/// enough for the `at_once` programs that may run; else more, so that no core is idle.
int threads_beside(int others, int at_once);

} // namespace integral

#endif
