// SPDX-License-Identifier: AGPL-3.0-or-later
// How much memory this process can still get.
#ifndef INTEGRAL_IO_MEMORY_H
#define INTEGRAL_IO_MEMORY_H

namespace integral {

/// Bytes of memory that are free for this process: what the machine has free (with what it would
/// drop from its cache), or less where a limit of the process (ulimit -v) or of its control group
/// leaves less. 1e300 where nothing of that is known.
double free_memory();

/// Throws std::runtime_error, a sentence with both figures, if so much memory is not free.
void check_memory(double bytes);

} // namespace integral

#endif
