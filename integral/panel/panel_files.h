// SPDX-License-Identifier: AGPL-3.0-or-later
// Names the files of a panel's images, and rejects names that would do harm.
#ifndef INTEGRAL_PANEL_PANEL_FILES_H
#define INTEGRAL_PANEL_PANEL_FILES_H

#include <string>
#include <vector>

namespace integral {

/// Checks the path of a test card. Throws RequestError for the name of a quilt, because a panel's
/// image would be taken for a quilt; OutputError if the path cannot be written.
void check_panel_file(const std::string& path);

/// The path of each group's image: `output` itself; with numbers, if there are several groups; or a
/// file in the folder `output`, named after the group's first input. Throws RequestError for names
/// of quilts, if two images would have one path, and if an input would be overwritten; OutputError
/// if a file cannot be written.
std::vector<std::string> panel_files(const std::string& output,
                                     const std::vector<std::vector<std::string>>& groups);

/// The path that gets numbers before its extension for the images of a video's quilts: `output`, or
/// a .png file in the folder `output`, named after the video. Throws as panel_files does.
std::string sequence_path(const std::string& output, const std::string& video);

} // namespace integral

#endif
