// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads picture files from bytes in memory: their error messages and notices.
#ifndef TESTS_UNIT_PICTURE_BYTES_H
#define TESTS_UNIT_PICTURE_BYTES_H

#include "integral/io/codecs.h"
#include "tests/unit/picture_files.h"

#include <stdexcept>

namespace picture_bytes {

using namespace integral;

/// The message with which bytes are refused; "" if they are read.
inline std::string refusal(const std::string& bytes)
{
    try {
        const InputFile file = InputFile::of_bytes(bytes);
        whole_picture(*read_any(file));
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

/// The notices of a picture that is read.
inline std::vector<std::string> notices_of(const std::string& bytes)
{
    const InputFile file = InputFile::of_bytes(bytes);
    const auto reader = read_any(file);
    whole_picture(*reader);
    return reader->take_notices();
}

} // namespace picture_bytes

#endif
