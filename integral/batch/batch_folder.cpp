// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/batch_folder.h"

#include "integral/base/file_bytes.h"
#include "integral/base/folders.h"
#include "integral/batch/content_hash.h"
#include "integral/io/codecs.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <set>
#include <sys/stat.h>
#include <unistd.h>

namespace integral {
namespace {

double size_of(const std::string& path)
{
    struct stat status;
    return stat(path.c_str(), &status) == 0 ? double(status.st_size) : 0;
}

bool has_content(const std::string& path, const StepRecord& record)
{
    try {
        return access(path.c_str(), F_OK) == 0 && size_of(path) == record.bytes &&
               hash_of_file(path) == record.output;
    } catch (const InputError&) {
        return false;
    }
}

/// Waits until a file or folder is on the disk. Throws OutputError if that fails: some file systems
/// report a full disk only then.
void sync(const std::string& path)
{
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const bool right = file >= 0 && (fsync(file) == 0 || errno == EINVAL);
    const int error = errno;
    if (file >= 0)
        close(file);
    if (!right)
        throw OutputError(path + ": cannot be written: " + std::strerror(error));
}

/// Moves a step's result to its output's path. Another process that has read the record may have
/// moved the file already.
void put_in_place(const BatchFolder& folder, const BatchStep& step, const StepRecord& record)
{
    const std::string output = folder.output(step);
    if (std::rename(folder.made(step).c_str(), output.c_str()) != 0) {
        const int error = errno;
        if (error != ENOENT || !has_content(output, record))
            throw OutputError(output + ": cannot be written: " + std::strerror(error));
    }
    sync(output.substr(0, output.rfind('/')));
}

} // namespace

BatchFolder batch_folder(const std::string& output)
{
    std::string path = std::filesystem::absolute(output).lexically_normal().string();
    while (path.size() > 1 && path.back() == '/')
        path.pop_back();
    return {path};
}

BatchFolder make_batch_folder(const std::string& output, const BatchPlan& plan)
{
    const BatchFolder folder = batch_folder(output);
    std::set<std::string> folders = {folder.own() + "/steps", folder.own() + "/locks",
                                     folder.own() + "/work", folder.path + "/logs"};
    for (const BatchStep& step : plan.steps)
        folders.insert(folder.path + "/" + step.output.substr(0, step.output.rfind('/')));
    for (const std::string& one : folders)
        make_folder(one);
    return folder;
}

bool is_done(const BatchFolder& folder, const BatchStep& step, const StepRecord& record,
             const std::string& inputs)
{
    if (record.state != StepState::done || record.inputs != inputs)
        return false;
    if (has_content(folder.output(step), record))
        return true;
    if (!has_content(folder.made(step), record))
        return false;
    put_in_place(folder, step, record);
    return true;
}

void publish(const BatchFolder& folder, const BatchStep& step, StepRecord record)
{
    const std::string made = folder.made(step);
    sync(made);
    record.state = StepState::done;
    record.output = hash_of_file(made);
    record.bytes = size_of(made);
    record.reason.clear();
    write_record(folder.record(step), record);
    put_in_place(folder, step, record);
}

bool is_whole(const std::string& path)
{
    const double size = size_of(path);
    if (extension_of(path) == "exr")
        return is_whole_exr(path);
    if (extension_of(path) != "png")
        return size > 0;
    constexpr std::size_t end_chunk = 12;
    char last[end_chunk] = "";
    std::ifstream file(path, std::ios::binary);
    file.seekg(-std::streamoff(end_chunk), std::ios::end);
    file.read(last, end_chunk);
    return size > double(end_chunk) && file && std::memcmp(last, "\0\0\0\0IEND", 8) == 0;
}

} // namespace integral
