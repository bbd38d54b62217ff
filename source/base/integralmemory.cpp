// SPDX-License-Identifier: AGPL-3.0-or-later

// configbase.h must be the first POV-Ray file included within base
#include "configbase.h"
#include "base/types.h"
#include "base/integralmemory.h"
#include "base/pov_err.h"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <string>
#include <sys/mman.h>
#include <unistd.h>

// this must be the last file included
#include "base/povdebug.h"

namespace pov_base
{

// A block of `least_bytes` or more gets large pages if the system has them: the kernel then has
// fewer pages to make. In a smaller block, large pages would waste memory.
static constexpr std::size_t large_page = std::size_t(2) << 20, least_bytes = 32 * large_page;

IntegralMemory::IntegralMemory(std::size_t bytes) : size(bytes)
{
    void *const start = mmap(NULL, size, PROT_READ | PROT_WRITE,
                             MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (start == MAP_FAILED)
        throw POV_EXCEPTION(kOutOfMemoryErr, "No " + std::to_string(bytes >> 20) +
                                                 " MB of addresses for anti-aliasing's samples: " +
                                                 std::strerror(errno));
    data = static_cast<char *>(start);
    if (size >= least_bytes)
        madvise(data, size, MADV_HUGEPAGE);
}

IntegralMemory::~IntegralMemory() { munmap(data, size); }

std::size_t IntegralMemory::Release(std::size_t begin, std::size_t end)
{
    const std::uintptr_t page = size >= least_bytes ? large_page
                                                    : std::uintptr_t(sysconf(_SC_PAGESIZE)),
                         start = reinterpret_cast<std::uintptr_t>(data),
                         first = (start + begin + page - 1) / page * page,
                         last = (start + end) / page * page;
    if (first >= last)
        return begin;
    madvise(reinterpret_cast<void *>(first), last - first, MADV_DONTNEED);
    return last - start;
}

}
