// SPDX-License-Identifier: AGPL-3.0-or-later
// Names the files that a panel's images go to, and refuses names that would do harm.
#ifndef INTEGRAL_OUTPUT_PANEL_FILES_H
#define INTEGRAL_OUTPUT_PANEL_FILES_H

#include <string>
#include <vector>

namespace integral {

/// The path of a test card. Throws RequestError for the name of a quilt, which a panel's image
/// would be taken for; OutputError where it cannot be written.
void check_panel_file(const std::string& path);

/// The path of each group's image: `output` itself; with numbers, where there are several; or in
/// the folder `output`, by the names of the groups' first inputs. Throws RequestError for names of
/// quilts, where two images would have one path, and where an input would be overwritten;
/// OutputError where a file cannot be written.
std::vector<std::string> panel_files(const std::string& output,
                                     const std::vector<std::vector<std::string>>& groups);

} // namespace integral

#endif
