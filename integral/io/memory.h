// SPDX-License-Identifier: AGPL-3.0-or-later
// Tells how much memory this process can still allocate.
#ifndef INTEGRAL_IO_MEMORY_H
#define INTEGRAL_IO_MEMORY_H

namespace integral {

/// Bytes of memory that this process can still allocate: the machine's available memory (including
/// reclaimable cache), or less if a limit of the process (ulimit -v) or of its control group allows
/// less. 1e300 if nothing of this is known.
double free_memory();

/// Throws std::runtime_error with both figures if less memory than `bytes` is free.
void check_memory(double bytes);

} // namespace integral

#endif
