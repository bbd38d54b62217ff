// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads and writes whole files as bytes. A write either replaces the file completely or leaves the
// old file as it was.
#ifndef INTEGRAL_BASE_FILE_BYTES_H
#define INTEGRAL_BASE_FILE_BYTES_H

#include "integral/base/atomic_file.h"
#include "integral/base/message_text.h"

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

namespace integral {

/// An input that cannot be read or is not valid. The message is one line, "FILE: what is wrong;
/// what would help".
struct InputError : std::runtime_error {
    explicit InputError(const std::string& message) : std::runtime_error(one_line(message)) {}
};

/// An output that could not be written. Its message has the same form as InputError's.
struct OutputError : std::runtime_error {
    explicit OutputError(const std::string& message) : std::runtime_error(one_line(message)) {}
};

/// The name of a path in messages: the path itself, or `standard_stream` ("standard input" or
/// "standard output") for "-".
std::string display_name(const std::string& path, const char* standard_stream);

/// The extension of a file name, in lower case and without its dot: "png". Empty if there is none.
std::string extension_of(const std::string& path);

/// Returns all bytes of a file; "-" reads standard input. Throws InputError.
std::string read_file(const std::string& path);

/// Writes a file. The bytes go to a temporary file in the same folder, which is synced and then
/// renamed to `path`, so that an old file stays whole until the new one is complete. Devices, pipes
/// and "-" (standard output) are written directly. Throws OutputError.
void write_file(const std::string& path, const std::string& bytes);

/// The destination of an encoder's bytes. It can be appended to, and bytes already written can be
/// overwritten and read back.
class ByteSink {
public:
    virtual ~ByteSink() = default;
    /// Writes `count` bytes at offset `at` <= size(). Throws OutputError or std::bad_alloc.
    virtual void write(std::uint64_t at, const void* bytes, std::size_t count) = 0;
    /// Reads back at most `count` written bytes from offset `at`; returns how many were read.
    virtual std::size_t read(std::uint64_t at, void* bytes, std::size_t count) = 0;
    virtual std::uint64_t size() const = 0;
};

/// A ByteSink in memory.
class ByteString : public ByteSink {
public:
    void write(std::uint64_t at, const void* bytes, std::size_t count) override;
    std::size_t read(std::uint64_t at, void* bytes, std::size_t count) override;
    std::uint64_t size() const override { return bytes.size(); }

    std::string bytes;
};

/// A file that is written piece by piece and appears under its name only when it is complete, as
/// with write_file. For devices, pipes and "-", the bytes are kept in memory until finish() writes
/// them.
class OutputFile : public ByteSink {
public:
    /// Creates the temporary file. Throws OutputError if that fails.
    explicit OutputFile(const std::string& path);
    /// Deletes the temporary file unless finish() has renamed it.
    ~OutputFile() override;
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write(std::uint64_t at, const void* bytes, std::size_t count) override;
    std::size_t read(std::uint64_t at, void* bytes, std::size_t count) override;
    std::uint64_t size() const override;

    /// Syncs the file to disk and renames it to its path. Throws OutputError if that or an earlier
    /// write failed; an old file at the path is then unchanged.
    void finish();

private:
    void flush();
    [[noreturn]] void fail(int error);

    std::string path_;                         ///< as given
    std::optional<AtomicFile> unfinished_;     ///< absent if the bytes are kept in memory
    int file_ = -1;                            ///< descriptor of the temporary file
    int error_ = 0;                            ///< errno of the first write that failed
    ByteString kept_;
    std::string buffer_; ///< not yet written
    std::uint64_t buffer_at_ = 0, size_ = 0;
};

/// Throws OutputError if write_file(path, ...) cannot succeed because the folder is missing or
/// read-only. Call it before long work.
void check_writable(const std::string& path);

} // namespace integral

#endif
