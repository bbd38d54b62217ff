// SPDX-License-Identifier: AGPL-3.0-or-later
// Allocates memory for data of every pixel of a frame. For large frames it is in a temporary file,
// as POV-Ray does for large images.
#ifndef POVRAY_BASE_INTEGRALMEMORY_H
#define POVRAY_BASE_INTEGRALMEMORY_H

#include <atomic>
#include <cstddef>

namespace pov_base
{

/// A block of bytes, initially 0. Parts that are neither written nor reserved take no memory or
/// disk space.
class IntegralMemory
{
public:
    /// `in_file`: use an unnamed file in POV-Ray's folder for temporary files. Throws
    /// pov_base::Exception if there is no room.
    IntegralMemory(std::size_t bytes, bool in_file);
    ~IntegralMemory();
    IntegralMemory(const IntegralMemory&) = delete;
    IntegralMemory& operator=(const IntegralMemory&) = delete;

    /// Allocates disk space for the bytes [begin, end). Call it before they are written to. Throws
    /// pov_base::Exception if there is no space. No effect without a file.
    void Reserve(std::size_t begin, std::size_t end);

    /// Reports that a number of bytes has been used; any thread may call it. After every 32 MB the
    /// pages of a file are released from main memory.
    void Used(std::size_t bytes);

    char *Data() const { return data; }

private:
    char *data;
    std::size_t size;
    int file = -1; ///< -1: none
    std::atomic<std::size_t> used{0};
};

}

#endif
