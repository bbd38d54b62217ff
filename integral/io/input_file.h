// SPDX-License-Identifier: AGPL-3.0-or-later
// A file that is read piece by piece, from any place: what is not asked for never comes into
// memory.
#ifndef INTEGRAL_IO_INPUT_FILE_H
#define INTEGRAL_IO_INPUT_FILE_H

#include <cstddef>
#include <cstdint>
#include <string>

namespace integral {

class InputFile {
public:
    /// Opens a file; "-" is standard input. What can be read only once, a pipe, is read into memory
    /// here. Throws InputError.
    explicit InputFile(const std::string& path);
    ~InputFile();
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    /// Bytes in memory, read as a file. They have to outlive it.
    static InputFile of_bytes(const std::string& bytes) { return InputFile(&bytes); }

    std::uint64_t size() const { return size_; }

    /// Copies `count` bytes, the first of which is byte `at`. Throws std::runtime_error where the
    /// file ends before the last one or cannot be read.
    void read(std::uint64_t at, void* to, std::size_t count) const;

    /// The first `count` bytes, or all if there are fewer. Throws as read does.
    std::string beginning(std::size_t count) const;

private:
    explicit InputFile(const std::string* bytes) : bytes_(bytes), size_(bytes->size()) {}

    int file_ = -1;
    std::string own_;                    ///< of what can be read only once
    const std::string* bytes_ = nullptr; ///< where there is no file
    std::uint64_t size_ = 0;
};

} // namespace integral

#endif
