// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/base/program_path.h"

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <unistd.h>

namespace integral {

std::optional<std::string> program_on_path(const std::string& name)
{
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (access((folder + "/" + name).c_str(), X_OK) == 0)
            return std::filesystem::weakly_canonical(folder + "/" + name).string();
    return std::nullopt;
}

} // namespace integral
