// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes folders for outputs.
#ifndef INTEGRAL_BASE_FOLDERS_H
#define INTEGRAL_BASE_FOLDERS_H

#include <string>

namespace integral {

/// Makes a folder and its missing parent folders. Throws OutputError with the reason if the folder
/// cannot be made or no file can be written to it.
void make_folder(const std::string& path);

} // namespace integral

#endif
