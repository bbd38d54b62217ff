// SPDX-License-Identifier: AGPL-3.0-or-later
// Memory for what is kept of every pixel of a frame: in a temporary file where the frame is large,
// as POV-Ray keeps large images.
#ifndef POVRAY_BASE_INTEGRALMEMORY_H
#define POVRAY_BASE_INTEGRALMEMORY_H

#include <atomic>
#include <cstddef>

namespace pov_base
{

/// A block of bytes, all 0 at first. It takes memory, or room on disk, only where it is written to.
class IntegralMemory
{
public:
    /// `in_file`: in a nameless file in POV-Ray's folder for temporary files. Throws
    /// pov_base::Exception if there is no room.
    IntegralMemory(std::size_t bytes, bool in_file);
    ~IntegralMemory();
    IntegralMemory(const IntegralMemory&) = delete;
    IntegralMemory& operator=(const IntegralMemory&) = delete;

    /// Takes the room on disk that bytes from `begin` up to `end` need, which has to be done before
    /// they are written to. Throws pov_base::Exception if there is none. No effect without a file.
    void Reserve(std::size_t begin, std::size_t end);

    /// To be told, by any thread, how many bytes have been used; every 32 MB those of a file
    /// go out of main memory.
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
