// SPDX-License-Identifier: AGPL-3.0-or-later

// configbase.h must be the first POV-Ray file included within base
#include "configbase.h"
#include "base/types.h"
#include "base/integralmemory.h"
#include "base/platformbase.h"
#include "base/pov_err.h"
#include "base/stringutilities.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

// this must be the last file included
#include "base/povdebug.h"

namespace pov_base
{

namespace
{

constexpr std::size_t most_used = std::size_t(32) << 20;

[[noreturn]] void No_Room(std::size_t bytes, int reason)
{
    throw POV_EXCEPTION(kOutOfMemoryErr,
                        "No room for " + std::to_string(bytes >> 20) +
                            " MB of anti-aliasing's samples: " + std::strerror(reason));
}

int Nameless_File(std::size_t bytes)
{
    std::string name = UCS2toASCIIString(POV_PLATFORM_BASE.GetTemporaryPath()) + "povXXXXXX";
    const int file = mkstemp(&name[0]);
    if (file < 0)
        No_Room(bytes, errno);
    unlink(name.c_str());
    if (ftruncate(file, off_t(bytes)) == 0)
        return file;
    const int reason = errno;
    close(file);
    No_Room(bytes, reason);
}

}

IntegralMemory::IntegralMemory(std::size_t bytes, bool in_file)
    : size(bytes), file(in_file ? Nameless_File(bytes) : -1)
{
    const int flags = in_file ? MAP_SHARED : MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE;
    void *const start = mmap(NULL, size, PROT_READ | PROT_WRITE, flags, file, 0);
    if (start == MAP_FAILED)
    {
        const int reason = errno;
        if (file >= 0)
            close(file);
        No_Room(bytes, reason);
    }
    data = static_cast<char *>(start);
}

IntegralMemory::~IntegralMemory()
{
    munmap(data, size);
    if (file >= 0)
        close(file);
}

void IntegralMemory::Reserve(std::size_t begin, std::size_t end)
{
    if (file < 0)
        return;
    if (const int reason = posix_fallocate(file, off_t(begin), off_t(end - begin)))
        No_Room(end - begin, reason);
}

void IntegralMemory::Used(std::size_t bytes)
{
    if (file < 0)
        return;
    const std::size_t before = used.fetch_add(bytes);
    if (before / most_used != (before + bytes) / most_used)
        madvise(data, size, MADV_DONTNEED); // the data stay in the file
}

}
