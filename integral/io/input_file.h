// SPDX-License-Identifier: AGPL-3.0-or-later
// Random access to a file's bytes without reading the whole file into memory.
#ifndef INTEGRAL_IO_INPUT_FILE_H
#define INTEGRAL_IO_INPUT_FILE_H

#include <cstddef>
#include <cstdint>
#include <string>

namespace integral {

class InputFile {
public:
    /// Opens a file; "-" is standard input. A pipe, which can be read only once, is read into
    /// memory here. Throws InputError.
    explicit InputFile(const std::string& path);
    ~InputFile();
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    /// Bytes in memory as an InputFile. The bytes must outlive the InputFile.
    static InputFile of_bytes(const std::string& bytes) { return InputFile(&bytes); }

    std::uint64_t size() const { return size_; }

    /// Copies `count` bytes from offset `at` to `to`. Throws std::runtime_error if the file ends
    /// before that or cannot be read.
    void read(std::uint64_t at, void* to, std::size_t count) const;

    /// The first `count` bytes, or all if there are fewer. Throws as read does.
    std::string beginning(std::size_t count) const { return part(0, count); }

    /// At most `count` bytes from offset `at`. Throws as read does.
    std::string part(std::uint64_t at, std::uint64_t count) const;

private:
    explicit InputFile(const std::string* bytes) : bytes_(bytes), size_(bytes->size()) {}

    int file_ = -1;
    std::string own_;                    ///< the bytes of a pipe
    const std::string* bytes_ = nullptr; ///< bytes in memory; null if a file is read
    std::uint64_t size_ = 0;
};

} // namespace integral

#endif
