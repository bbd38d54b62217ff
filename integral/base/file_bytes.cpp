// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/base/file_bytes.h"

#include "integral/base/memory.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <stdexcept>
#include <sys/stat.h>
#include <unistd.h>

namespace integral {
namespace {

std::string reason(int error) { return std::strerror(error); }

[[noreturn]] void fail_to_write(const std::string& path, int error)
{
    throw OutputError(display_name(path, "standard output") +
                      ": cannot be written: " + reason(error));
}

/// A file descriptor that closes itself.
class Descriptor {
public:
    explicit Descriptor(int fd) : fd_(fd) {}
    ~Descriptor()
    {
        if (fd_ > 2)
            close(fd_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int get() const { return fd_; }

private:
    int fd_;
};

/// Writes all `bytes` by repeated calls of write(data, count), which returns what write(2) returns.
/// Returns 0 or errno.
template <class Write> int write_all(const std::string& bytes, Write write)
{
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t n = write(bytes.data() + done, bytes.size() - done);
        if (n < 0 && errno == EINTR)
            continue;
        if (n < 0)
            return errno;
        done += std::size_t(n);
    }
    return 0;
}

std::string folder_of(const std::string& path)
{
    const auto slash = path.rfind('/');
    return slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
}

void write_straight(const std::string& path, const std::string& bytes)
{
    Descriptor file(path == "-" ? STDOUT_FILENO : open(path.c_str(), O_WRONLY));
    if (file.get() < 0)
        fail_to_write(path, errno);
    const auto to_file = [&](const char* from, std::size_t count) {
        return write(file.get(), from, count);
    };
    if (const int error = write_all(bytes, to_file))
        fail_to_write(path, error);
}

} // namespace

std::string display_name(const std::string& path, const char* standard_stream)
{
    return path == "-" ? standard_stream : path;
}

std::string extension_of(const std::string& path)
{
    const auto dot = path.rfind('.'), slash = path.rfind('/');
    if (dot == std::string::npos || (slash != std::string::npos && dot < slash))
        return "";
    std::string extension = path.substr(dot + 1);
    for (char& c : extension)
        c = char(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

std::string read_file(const std::string& path)
{
    constexpr std::size_t most_of_device = std::size_t(1) << 26, small = std::size_t(1) << 24;
    const std::string name = display_name(path, "standard input");
    const auto refuse = [&](const std::string& why) {
        throw InputError(name + ": cannot be read: " + why);
    };
    Descriptor file(path == "-" ? STDIN_FILENO : open(path.c_str(), O_RDONLY));
    if (file.get() < 0)
        refuse(reason(errno));
    std::string bytes;
    const auto reserve = [&](std::size_t count) {
        try {
            if (count > small)
                check_memory(double(count));
        } catch (const std::runtime_error& error) {
            refuse(error.what());
        }
        bytes.reserve(count);
    };
    struct stat status = {};
    if (fstat(file.get(), &status) == 0 && S_ISREG(status.st_mode))
        reserve(std::size_t(status.st_size) + 1);
    std::string buffer(1 << 16, '\0');
    for (;;) {
        const ssize_t n = read(file.get(), &buffer[0], buffer.size());
        if (n < 0 && errno == EINTR)
            continue;
        if (n < 0)
            refuse(reason(errno));
        if (n == 0)
            return bytes;
        if (S_ISCHR(status.st_mode) && bytes.size() >= most_of_device)
            refuse("it is a device that does not end; give a file");
        const std::size_t size = bytes.size() + std::size_t(n);
        if (size > bytes.capacity())
            reserve(2 * size);
        bytes.append(buffer, 0, std::size_t(n));
    }
}

void write_file(const std::string& path, const std::string& bytes)
{
    if (path == "-" || is_special(path))
        return write_straight(path, bytes);
    OutputFile file(path);
    file.write(0, bytes.data(), bytes.size());
    file.finish();
}

void ByteString::write(std::uint64_t at, const void* from, std::size_t count)
{
    if (at + count > bytes.size())
        bytes.resize(std::size_t(at) + count);
    std::memcpy(&bytes[std::size_t(at)], from, count);
}

std::size_t ByteString::read(std::uint64_t at, void* to, std::size_t count)
{
    if (at >= bytes.size())
        return 0;
    count = std::min(count, bytes.size() - std::size_t(at));
    std::memcpy(to, bytes.data() + at, count);
    return count;
}

OutputFile::OutputFile(const std::string& path) : path_(path)
{
    if (path == "-" || is_special(path))
        return;
    const std::string target = target_of(path);
    std::string beside;
    file_ = create_unfinished(target, beside);
    if (file_ < 0)
        fail_to_write(path, errno);
    unfinished_.emplace(beside, target);
}

OutputFile::~OutputFile()
{
    if (file_ >= 0)
        close(file_);
}

void OutputFile::fail(int error)
{
    error_ = error;
    fail_to_write(path_, error);
}

void OutputFile::flush()
{
    std::uint64_t at = buffer_at_;
    const auto to_file = [&](const char* from, std::size_t count) {
        const ssize_t n = pwrite(file_, from, count, off_t(at));
        at += n > 0 ? std::uint64_t(n) : 0;
        return n;
    };
    const int error = write_all(buffer_, to_file);
    buffer_at_ += buffer_.size();
    buffer_.clear();
    if (error)
        fail(error);
}

void OutputFile::write(std::uint64_t at, const void* bytes, std::size_t count)
{
    if (!unfinished_)
        return kept_.write(at, bytes, count);
    if (error_)
        fail(error_);
    constexpr std::size_t most = 1 << 20;
    const char* from = static_cast<const char*>(bytes);
    if (at != buffer_at_ + buffer_.size())
        flush();
    if (buffer_.empty())
        buffer_at_ = at;
    for (std::size_t done = 0; done < count;) {
        const std::size_t piece = std::min(count - done, most - buffer_.size());
        buffer_.append(from + done, piece);
        done += piece;
        if (buffer_.size() == most)
            flush();
    }
    size_ = std::max(size_, at + count);
}

std::size_t OutputFile::read(std::uint64_t at, void* bytes, std::size_t count)
{
    if (!unfinished_)
        return kept_.read(at, bytes, count);
    flush();
    const ssize_t n = pread(file_, bytes, count, off_t(at));
    return n > 0 ? std::size_t(n) : 0;
}

std::uint64_t OutputFile::size() const { return !unfinished_ ? kept_.size() : size_; }

void OutputFile::finish()
{
    if (!unfinished_)
        return write_straight(path_, kept_.bytes);
    if (error_)
        fail(error_);
    flush();
    const std::string target = unfinished_->target();
    int error = fchmod(file_, mode_for(target)) != 0 || fsync(file_) != 0 ? errno : 0;
    if (close(file_) != 0 && !error)
        error = errno;
    file_ = -1;
    if (!error)
        error = unfinished_->finish();
    if (error)
        fail(error);
    // The rename is durable once the folder is synced; a folder that cannot be synced is no error.
    const Descriptor folder(open(folder_of(target).c_str(), O_RDONLY | O_DIRECTORY));
    if (folder.get() >= 0 && fsync(folder.get()) != 0)
        errno = 0;
}

void check_writable(const std::string& path)
{
    if (path == "-" || is_special(path))
        return;
    struct stat status;
    if (path.empty() || path.back() == '/' ||
        (stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode)))
        fail_to_write(path, EISDIR);
    if (access(folder_of(target_of(path)).c_str(), W_OK | X_OK) != 0)
        fail_to_write(path, errno);
}

} // namespace integral
