// SPDX-License-Identifier: AGPL-3.0-or-later
// What decides when a batch's steps begin and with how much of the machine: order and threads.
#ifndef INTEGRAL_BATCH_BATCH_SCHEDULE_H
#define INTEGRAL_BATCH_BATCH_SCHEDULE_H

#include "integral/batch/batch_folder.h"

#include <list>

namespace integral {

/// Puts steps of the plan in the order in which they are to begin: the longest first, by what is
/// known of their last run or by their pixels; then the last ones to end do so at nearly the same
/// time. What a frame's steps make of it comes at once.
void sort_longest_first(std::list<int>& steps, const BatchPlan& plan, const BatchFolder& folder);

/// Threads of a step that begins when `others` more could: one while there is enough to do; the
/// last frames have more, so that no core of `at_once` is idle while they end.
int threads_beside(int others, int at_once);

} // namespace integral

#endif
