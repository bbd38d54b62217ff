// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/panel/panel_files.h"

#include "integral/base/file_bytes.h"
#include "integral/frame/quilt_name.h"
#include "integral/io/image_file.h"
#include "integral/io/picture_series.h"
#include "integral/views/view_input.h"

#include <filesystem>
#include <set>

namespace integral {
namespace {

/// The path of one of several images. A panel's image is not a quilt, so its name in a folder loses
/// a quilt's suffix.
std::string path_of(const std::string& output, const std::vector<std::string>& group, int index,
                    int count)
{
    if (std::filesystem::is_directory(output))
        return (std::filesystem::path(output) /
                std::filesystem::path(without_grid(group[0])).filename())
            .string();
    return count == 1 ? output : numbered(output, index + 1, count);
}

void check_name(const std::string& path)
{
    if (quilt_in_name(path))
        throw RequestError("-o " + path + ": such a name says that it is a quilt; " +
                           without_grid(path) + " would do");
    format_for(path);
}

} // namespace

void check_panel_file(const std::string& path)
{
    check_name(path);
    check_writable(path);
}

std::vector<std::string> panel_files(const std::string& output,
                                     const std::vector<std::vector<std::string>>& groups)
{
    const int count = int(groups.size());
    if (output == "-" && count > 1)
        throw RequestError("-o -: several images need a name or a folder");
    if (!std::filesystem::is_directory(output)) {
        if (!output.empty() && output.back() == '/')
            throw OutputError(output + ": there is no such folder; make it first");
        format_for(output);
    }
    std::vector<std::string> paths;
    std::set<std::string> different;
    for (int k = 0; k < count; ++k) {
        const std::string path = path_of(output, groups[std::size_t(k)], k, count);
        check_name(path);
        if (!different.insert(path).second)
            throw RequestError("-o " + output + ": two inputs would make " + path +
                               "; -o NAME.png numbers the images");
        check_writable(path);
        std::error_code none; // ignored: reading a missing file reports it
        for (const std::string& input : groups[std::size_t(k)])
            if (std::filesystem::equivalent(path, input, none))
                throw RequestError("-o " + output + ": it would overwrite the input " + input);
        paths.push_back(path);
    }
    return paths;
}

std::string sequence_path(const std::string& output, const std::string& video)
{
    if (output == "-")
        throw RequestError("-o -: a video's images need a name or a folder");
    if (is_animation(output))
        throw RequestError("-o " + output +
                           ": compression mixes the colours of neighbouring subpixels; -o NAME.png "
                           "writes numbered images, and --play shows them at once");
    const std::filesystem::path folder(output);
    const std::string path = std::filesystem::is_directory(folder)
                                 ? (folder / std::filesystem::path(without_grid(video)).stem())
                                           .string() +
                                       ".png"
                                 : output;
    if (path.back() == '/')
        throw OutputError(path + ": there is no such folder; make it first");
    check_name(path);
    check_writable(path);
    return path;
}

} // namespace integral
