// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/batch_steps.h"

#include "integral/base/programs.h"
#include "integral/batch/renderer.h"
#include "integral/batch/renderer_options.h"
#include "integral/io/codecs.h"
#include "integral/io/image_file.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <sys/statvfs.h>
#include <unistd.h>

namespace integral {
namespace {

constexpr double default_pixels = 800.0 * 600; // the renderer's default size
constexpr int thumbnail_side = 240;            // pixels

/// Searches PATH for a name without a folder and returns its path; returns other names unchanged.
std::string found_on_path(const std::string& name)
{
    return name.find('/') == std::string::npos ? program_on_path(name).value_or(name) : name;
}

/// The text with single blanks between its words.
std::string tidy(const std::string& text)
{
    std::istringstream words(text);
    std::string word, all;
    while (words >> word)
        all += (all.empty() ? "" : " ") + word;
    return all;
}

std::string last_line(const std::string& text)
{
    std::istringstream lines(text);
    std::string line, last;
    while (std::getline(lines, line))
        if (line.find_first_not_of(" \r\t") != std::string::npos)
            last = line;
    return last;
}

/// A file's first bytes, enough for the header of a frame.
std::string beginning_of(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    std::string bytes(1 << 18, '\0');
    file.read(&bytes[0], std::streamsize(bytes.size()));
    bytes.resize(std::size_t(std::max<std::streamsize>(0, file.gcount())));
    return bytes;
}

bool disk_is_full(const std::string& path)
{
    constexpr double least = 1 << 16; // bytes
    struct statvfs disk;
    return statvfs(path.substr(0, path.rfind('/')).c_str(), &disk) == 0 &&
           double(disk.f_bavail) * double(disk.f_frsize) < least;
}

std::string thumbnail_size(const std::string& frame)
{
    const PictureHeader size = frame_header(frame);
    const double scale = double(thumbnail_side) / std::max(size.width, size.height);
    const auto side = [&](int pixels) {
        return std::to_string(std::max(1, int(std::lround(pixels * scale))));
    };
    return side(size.width) + "x" + side(size.height);
}

/// The first message about the frame `frame` in the log of a step's program that succeeded, without
/// the names of the program and the frame. Empty if there is none.
std::string remark_of(const BatchStep& step, const std::string& log, const std::string& frame)
{
    const std::string mark = one_line("integral " + step.words[0] + ": " + frame + ": ");
    std::ifstream said(log);
    std::string line, remark;
    while (remark.empty() && std::getline(said, line))
        if (line.rfind(mark, 0) == 0)
            remark = tidy(line.substr(mark.size()));
    return remark;
}

} // namespace

BatchPrograms batch_programs()
{
    BatchPrograms programs;
    programs.integral_version = PACKAGE_VERSION;
    const std::string renderer = renderer_program();
    programs.renderer_share = std::filesystem::path(found_on_path(renderer))
                                  .parent_path()
                                  .parent_path()
                                  .string() +
                              "/share/povray-integral-3.7";
    const ScratchFolder scratch;
    const std::string said = scratch.path("version.txt");
    const ChildEnd end = ChildProcess({renderer, "--version"}, ".", said).wait();
    programs.renderer_version = tidy(read_file(said));
    if (end.status != 0)
        throw no_renderer(read_file(said));
    return programs;
}

std::vector<std::string> command_line(const BatchFolder& folder, const BatchStep& step,
                                      const std::string& frame, int threads)
{
    const std::string made = folder.made(step);
    std::vector<std::string> words;
    if (step.kind == StepKind::frame) {
        words.push_back(renderer_program());
        words.insert(words.end(), step.words.begin(), step.words.end());
        if (step.threads == 0)
            words.push_back("+WT" + std::to_string(threads));
        words.push_back("+O" + quoted(made));
        return words;
    }
    words.push_back(own_program());
    words.insert(words.end(), step.words.begin(), step.words.end());
    std::replace(words.begin(), words.end(), std::string(frame_word), frame);
    const bool html = extension_of(made) == "html";
    if (step.kind == StepKind::thumbnail)
        words.insert(words.end(), {"--size", thumbnail_size(frame)});
    const bool own_threads = std::any_of(words.begin(), words.end(), [](const std::string& word) {
        return word.rfind("--threads", 0) == 0;
    });
    if (step.words[0] == "replay" && !own_threads)
        words.insert(words.end(), {"--threads", std::to_string(threads)});
    words.insert(words.end(), {html ? "--html" : "--output", made});
    return words;
}

PictureHeader frame_header(const std::string& path)
{
    try {
        const std::string bytes = beginning_of(path);
        return extension_of(path) == "exr" ? decode_exr_header(bytes) : decode_png_header(bytes);
    } catch (const std::exception& error) {
        throw InputError(path + ": it cannot be read: " + error.what());
    }
}

FrameMetadata metadata_in(const PictureHeader& header)
{
    try {
        if (!header.document.empty())
            return frame_metadata_from_json(header.document);
    } catch (const std::invalid_argument&) { // a document of another kind
    }
    throw InputError(
        "the scene's camera is not integral; give it a sheet of the manifest's \"sheets\"");
}

double pixels_of(const BatchStep& step, const std::string& frame)
{
    if (step.size.width > 0)
        return double(step.size.width) * step.size.height;
    if (!frame.empty()) {
        const PictureHeader header = frame_header(frame);
        return double(header.width) * header.height;
    }
    return default_pixels;
}

std::string failure_of(const BatchStep& step, const std::string& log, const ChildEnd& end)
{
    if (end.signal == SIGKILL)
        return "it was killed (signal 9), as happens where memory runs out";
    if (end.signal != 0)
        return std::string("it was ended by signal ") + std::to_string(end.signal) + " (" +
               strsignal(end.signal) + ")";
    std::string said;
    try {
        said = read_file(log);
    } catch (const InputError&) { // on a full disk there may be no log
    }
    const std::string full = disk_is_full(log) ? "; the disk is full" : "";
    if (end.status == 0)
        return step.kind == StepKind::frame
                   ? "the renderer wrote no whole frame" + full
                   : "it wrote no whole file of the name that the batch gave it" +
                         (full.empty() ? "; its options may write several" : full);
    std::string reason = tidy(step.kind == StepKind::frame ? reason_in(said) : last_line(said));
    const std::string prefix = "integral " + step.words[0] + ": ";
    if (step.kind != StepKind::frame && reason.rfind(prefix, 0) == 0)
        reason.erase(0, prefix.size());
    return (reason.empty() ? "its program ended with status " + std::to_string(end.status)
                           : reason) +
           full;
}

void read_figures(const std::string& frame, StepRecord& record)
{
    const PictureHeader header = frame_header(frame);
    const FrameMetadata metadata = metadata_in(header);
    record.pixels = double(header.width) * header.height;
    if (metadata.render)
        record.render_seconds = metadata.render->seconds;
    if (metadata.render && metadata.render->error)
        record.error = metadata.render->error->rms;
}

std::string publish_made(const BatchFolder& folder, const BatchStep& step, const std::string& frame,
                         const std::string& log, const ChildEnd& end, StepRecord& record)
{
    const std::string made = folder.made(step);
    record.memory = end.memory;
    record.finished = time_now();
    record.host = host_name();
    try {
        if (end.signal != 0 || end.status != 0 || !is_whole(made))
            return failure_of(step, log, end);
        if (step.kind == StepKind::frame)
            read_figures(made, record);
        else
            record.remark = remark_of(step, log, frame);
        if (step.rows)
            cut_strip(made, *step.rows, made);
        publish(folder, step, record);
    } catch (const InputError& error) {
        return error.what();
    } catch (const OutputError& error) {
        return error.what();
    }
    return "";
}

void publish_copy(const BatchFolder& folder, const BatchStep& step, const BatchStep& other,
                  StepRecord& record)
{
    const StepRecord theirs = read_record(folder.record(other));
    std::error_code error;
    std::filesystem::copy_file(folder.output(other), folder.made(step), error);
    if (error)
        throw OutputError(folder.made(step) + ": cannot be written: " + error.message());
    record.seconds = theirs.seconds;
    record.memory = theirs.memory;
    record.render_seconds = theirs.render_seconds;
    record.error = theirs.error;
    record.remark = theirs.remark;
    record.finished = time_now();
    record.host = host_name();
    publish(folder, step, record);
}

std::string time_now()
{
    const std::time_t now = std::time(nullptr);
    char text[40] = "";
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
    return text;
}

} // namespace integral
