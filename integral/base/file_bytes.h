// SPDX-License-Identifier: AGPL-3.0-or-later
// Whole files as bytes; writing that either succeeds whole or leaves things as they were.
#ifndef INTEGRAL_BASE_FILE_BYTES_H
#define INTEGRAL_BASE_FILE_BYTES_H

#include "integral/base/message_text.h"
#include "integral/base/unfinished_file.h"

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

namespace integral {

/// An input that cannot be read or makes no sense. The message is one line, "FILE: what is
/// wrong; what would help".
struct InputError : std::runtime_error {
    explicit InputError(const std::string& message) : std::runtime_error(one_line(message)) {}
};

/// An output that could not be written. Same form.
struct OutputError : std::runtime_error {
    explicit OutputError(const std::string& message) : std::runtime_error(one_line(message)) {}
};

/// The name by which messages call a path: "-" is standard input or output.
std::string display_name(const std::string& path, const char* standard_stream);

/// What follows the last dot of a path's own name, in small letters: "png"; empty if there is no
/// dot.
std::string extension_of(const std::string& path);

/// All bytes of a file; "-" reads standard input. Throws InputError.
std::string read_file(const std::string& path);

/// Writes a file: beside it under another name, synced, then renamed over it, so that a file
/// that was there stays whole until the new one is. Devices, pipes and "-" (standard output) are
/// written straight. Throws OutputError.
void write_file(const std::string& path, const std::string& bytes);

/// Where an encoder writes its bytes: one after another, or over ones that it has written.
class ByteSink {
public:
    virtual ~ByteSink() = default;
    /// Writes at `at`, which is not beyond the end. Throws OutputError or std::bad_alloc.
    virtual void write(std::uint64_t at, const void* bytes, std::size_t count) = 0;
    /// Reads back at most `count` written bytes from `at` on; returns how many there are.
    virtual std::size_t read(std::uint64_t at, void* bytes, std::size_t count) = 0;
    virtual std::uint64_t size() const = 0;
};

/// Bytes written to memory.
class ByteString : public ByteSink {
public:
    void write(std::uint64_t at, const void* bytes, std::size_t count) override;
    std::size_t read(std::uint64_t at, void* bytes, std::size_t count) override;
    std::uint64_t size() const override { return bytes.size(); }

    std::string bytes;
};

/// A file that is written piece by piece and appears whole or not at all: as write_file does it.
/// What devices, pipes and "-" get is kept in memory until finish() writes it.
class OutputFile : public ByteSink {
public:
    /// Throws OutputError where the file cannot be made.
    explicit OutputFile(const std::string& path);
    /// Takes away what is unfinished.
    ~OutputFile() override;
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write(std::uint64_t at, const void* bytes, std::size_t count) override;
    std::size_t read(std::uint64_t at, void* bytes, std::size_t count) override;
    std::uint64_t size() const override;

    /// Gives the file its name, once it is on disk. Throws OutputError, too where a write before
    /// has failed: then what was at the path is unharmed.
    void finish();

private:
    void flush();
    [[noreturn]] void fail(int error);

    std::string path_;                         ///< as given
    std::optional<UnfinishedFile> unfinished_; ///< none: kept in memory
    int file_ = -1;                            ///< its descriptor
    int error_ = 0;                            ///< of the first write that failed
    ByteString kept_;
    std::string buffer_; ///< not yet written
    std::uint64_t buffer_at_ = 0, size_ = 0;
};

/// Throws OutputError if write_file(path, ...) must fail: its folder is missing or read-only.
/// For use before long work.
void check_writable(const std::string& path);

} // namespace integral

#endif
