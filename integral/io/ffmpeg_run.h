// SPDX-License-Identifier: AGPL-3.0-or-later
// Runs the programs ffmpeg and ffprobe.
#ifndef INTEGRAL_IO_FFMPEG_RUN_H
#define INTEGRAL_IO_FFMPEG_RUN_H

#include <string>
#include <sys/types.h>
#include <vector>

namespace integral {

/// A running program. Its destructor ends it.
class FfmpegRun {
public:
    /// Starts the program of the first word. `input`, `output`: file descriptors as in
    /// start_program; they stay open here.
    FfmpegRun(const std::vector<std::string>& words, int input, int output);
    ~FfmpegRun();
    FfmpegRun(const FfmpegRun&) = delete;
    FfmpegRun& operator=(const FfmpegRun&) = delete;

    bool has_started() const { return error_ == 0; }

    /// Waits for the program's end. Returns the error: the first line that it printed, or how it
    /// ended; empty if it succeeded.
    std::string end();

    /// The first line that it has printed as an error; empty if there is none.
    std::string first_error() const;

private:
    pid_t process_ = -1;
    int errors_ = -1, error_ = 0, status_ = 0;
};

} // namespace integral

#endif
