// SPDX-License-Identifier: AGPL-3.0-or-later
// Work shared by threads, row by row.
#ifndef INTEGRAL_BASE_PARALLEL_H
#define INTEGRAL_BASE_PARALLEL_H

#include <functional>

namespace integral {

/// How long work is followed: called with the rows done so far and their total, never by two
/// threads at once. Returning false stops the work. May be empty.
using Progress = std::function<bool(int done, int total)>;

/// The progress of one of `count` pieces of work of the same length.
Progress piece_of(const Progress& whole, int index, int count);

/// Calls work(row) once for each row in [0, rows), from `threads` threads (0: one per core).
/// Returns whether every row was done: false if `progress` stopped it. Rethrows the first
/// exception that `work` throws, after all threads have ended.
bool for_each_row(int rows, int threads, const std::function<void(int row)>& work,
                  const Progress& progress = {});

} // namespace integral

#endif
