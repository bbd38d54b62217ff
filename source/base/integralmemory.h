// SPDX-License-Identifier: AGPL-3.0-or-later
// Allocates memory for the data of a frame's pixels. Only some of its rows are in use at a time.
#ifndef POVRAY_BASE_INTEGRALMEMORY_H
#define POVRAY_BASE_INTEGRALMEMORY_H

#include <cstddef>

namespace pov_base
{

/// A block of bytes, initially 0. Parts that have not been written, or have been released, take no
/// main memory.
class IntegralMemory
{
public:
    /// Throws pov_base::Exception if the address space is too small.
    explicit IntegralMemory(std::size_t bytes);
    ~IntegralMemory();
    IntegralMemory(const IntegralMemory&) = delete;
    IntegralMemory& operator=(const IntegralMemory&) = delete;

    /// Releases the whole pages of main memory in [begin, end), whose bytes must not be used again.
    /// Returns where the next release is to begin: `begin`, or the end of the last page released.
    std::size_t Release(std::size_t begin, std::size_t end);

    char *Data() const { return data; }

private:
    char *data;
    std::size_t size;
};

}

#endif
