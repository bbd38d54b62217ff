// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/input_file.h"

#include "integral/base/file_bytes.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <stdexcept>
#include <sys/stat.h>
#include <unistd.h>

namespace integral {

InputFile::InputFile(const std::string& path)
{
    struct stat status;
    if (path != "-")
        file_ = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file_ >= 0 && fstat(file_, &status) == 0 && S_ISREG(status.st_mode)) {
        size_ = std::uint64_t(status.st_size);
        return;
    }
    if (file_ >= 0)
        close(file_);
    file_ = -1;
    own_ = read_file(path); // throws InputError with the reason if it cannot be opened
    bytes_ = &own_;
    size_ = own_.size();
}

InputFile::~InputFile()
{
    if (file_ >= 0)
        close(file_);
}

void InputFile::read(std::uint64_t at, void* to, std::size_t count) const
{
    if (at > size_ || count > size_ - at)
        throw std::runtime_error("the file ends too early");
    if (bytes_) {
        std::memcpy(to, bytes_->data() + at, count);
        return;
    }
    for (std::size_t done = 0; done < count;) {
        const ssize_t n = pread(file_, static_cast<char*>(to) + done, count - done,
                                off_t(at + done));
        if (n < 0 && errno == EINTR)
            continue;
        if (n < 0)
            throw std::runtime_error(std::strerror(errno));
        if (n == 0) // another program has truncated the file
            throw std::runtime_error("the file ends too early");
        done += std::size_t(n);
    }
}

std::string InputFile::part(std::uint64_t at, std::uint64_t count) const
{
    const std::uint64_t rest = size_ - std::min(at, size_);
    std::string bytes(std::size_t(std::min(count, rest)), '\0');
    read(std::min(at, size_), &bytes[0], bytes.size());
    return bytes;
}

} // namespace integral
