// SPDX-License-Identifier: AGPL-3.0-or-later
// Determines how much memory this process can still allocate.
#ifndef INTEGRAL_BASE_MEMORY_H
#define INTEGRAL_BASE_MEMORY_H

#include <string>

namespace integral {

/// Bytes of memory that this process can still allocate: free_memory_of_machine, or less if a limit
/// of the process (ulimit -v) allows less. 1e300 if neither limit is known.
double free_memory();

/// Bytes that this process and the processes that it starts can still allocate together: the
/// machine's available memory (including reclaimable cache), or less if their control group allows
/// less. 1e300 if neither is known.
double free_memory_of_machine();

/// Bytes that may still be allocated under the limits of this process's control group and of the
/// groups above it (cgroup versions 1 and 2); file cache counts as free. 1e300 if there is no
/// limit. `root` is the folder in which /proc and /sys lie: "", except in tests.
double free_of_control_groups(const std::string& root);

/// Bytes that a process, by default this one, has in memory now; 0 if that is not known.
double resident_memory(const std::string& process = "self");

/// Throws std::runtime_error with both figures if less memory than `bytes` is free.
void check_memory(double bytes);

} // namespace integral

#endif
