// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/ffmpeg_run.h"

#include "integral/base/programs.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <sys/mman.h>
#include <unistd.h>

namespace integral {

FfmpegRun::FfmpegRun(const std::vector<std::string>& words, int input, int output)
    : errors_(memfd_create("errors", MFD_CLOEXEC)) // takes any number of lines, so nothing waits
{
    if (errors_ < 0) {
        error_ = errno;
        return;
    }
    const StartedProgram started = start_program(words, input, output, errors_);
    process_ = started.process;
    error_ = started.error;
}

FfmpegRun::~FfmpegRun()
{
    if (process_ > 0) {
        kill(process_, SIGKILL);
        wait_for_program(process_);
    }
    if (errors_ >= 0)
        close(errors_);
}

std::string FfmpegRun::first_error() const
{
    char text[1000];
    const ssize_t count = errors_ < 0 ? 0 : pread(errors_, text, sizeof text, 0);
    return std::string(text, std::find(text, text + std::max<ssize_t>(count, 0), '\n'));
}

std::string FfmpegRun::end()
{
    if (error_ != 0)
        return std::strerror(error_);
    if (process_ > 0)
        status_ = wait_for_program(process_);
    process_ = -1;
    if (status_ == 0)
        return "";
    const std::string line = first_error();
    return line.empty() ? "it ended with status " + std::to_string(status_) : line;
}

} // namespace integral
