// SPDX-License-Identifier: AGPL-3.0-or-later
// Detects that a file was written.
#ifndef INTEGRAL_STUDIO_FILE_STAMP_H
#define INTEGRAL_STUDIO_FILE_STAMP_H

#include <filesystem>
#include <string>

namespace integral {

/// Size and time of a file: equal stamps mean that it was not written in between. Empty if there is
/// no such file.
inline std::string file_stamp(const std::string& path)
{
    std::error_code error;
    const auto size = std::filesystem::file_size(path, error);
    if (error)
        return "";
    const auto time = std::filesystem::last_write_time(path, error);
    return std::to_string(size) + "@" + std::to_string(time.time_since_epoch().count());
}

} // namespace integral

#endif
