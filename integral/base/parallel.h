// SPDX-License-Identifier: AGPL-3.0-or-later
// Divides work on rows among threads.
#ifndef INTEGRAL_BASE_PARALLEL_H
#define INTEGRAL_BASE_PARALLEL_H

#include <functional>

namespace integral {

/// Callback for the progress of long work: called with the number of rows done and the total, never
/// by two threads at once. If it returns false, the work stops. May be empty.
using Progress = std::function<bool(int done, int total)>;

/// The callback for piece `index` of `count` equally long pieces of work. It reports the progress
/// of the work as a whole to `whole`. Empty if `whole` is empty.
Progress piece_of(const Progress& whole, int index, int count);

/// Calls work(row) once for each row in [0, rows), from `threads` threads (0: one per core).
/// Returns true if every row was done, false if `progress` stopped the work. Rethrows the first
/// exception that `work` throws, after all threads have ended.
bool for_each_row(int rows, int threads, const std::function<void(int row)>& work,
                  const Progress& progress = {});

} // namespace integral

#endif
