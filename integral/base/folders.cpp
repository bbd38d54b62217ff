// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/base/folders.h"

#include "integral/base/file_bytes.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include <unistd.h>

namespace integral {

void make_folder(const std::string& path)
{
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error)
        throw OutputError(path + ": cannot be made: " + error.message());
    if (access(path.c_str(), W_OK | X_OK) != 0)
        throw OutputError(path + ": cannot be written: " + std::strerror(errno));
}

} // namespace integral
