// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/terminal_progress.h"

#include "integral/base/interrupt.h"
#include "integral/base/message_text.h"
#include "integral/base/number_text.h"

#include <cmath>
#include <cstdio>
#include <memory>
#include <unistd.h>

namespace integral {
namespace {

std::string time_text(double seconds)
{
    constexpr double minute = 60, hour = 3600;
    if (seconds < minute)
        return with_decimals(std::ceil(seconds), 0) + " s";
    if (seconds < hour)
        return with_decimals(std::ceil(seconds / minute), 0) + " min";
    const double hours = std::floor(seconds / hour);
    return with_decimals(hours, 0) + " h " +
           with_decimals(std::floor((seconds - hours * hour) / minute), 0) + " min";
}

std::string bar_text(const BatchState& state)
{
    constexpr int width = 30;
    constexpr std::size_t most_name = 24;
    const int full = int(state.done * width);
    char percent[16];
    std::snprintf(percent, sizeof percent, "%5.1f%%", 100 * state.done);
    std::string text = "batch [" + std::string(std::size_t(full), '#') +
                       std::string(std::size_t(width - full), '.') + "] " + percent;
    if (state.seconds_left)
        text += ", " + time_text(*state.seconds_left) + " left";
    if (!state.jobs.empty())
        text += ": " + excerpt(state.jobs[0], most_name);
    if (state.jobs.size() > 1)
        text += " and " + std::to_string(state.jobs.size() - 1) + " more";
    return one_line(text);
}

} // namespace

BatchReporter batch_reporter()
{
    BatchReporter reporter;
    if (!isatty(STDERR_FILENO)) {
        reporter.state = [](const BatchState&) { return !interrupted(); };
        reporter.job_ended = [](const JobEnd& job) {
            say("batch", job.job + ": " +
                             (job.failed ? "failed" : "done in " + time_text(job.seconds)) + ", " +
                             std::to_string(job.ended) + " of " + counted(job.jobs, "job"));
        };
        return reporter;
    }
    const auto shown = std::make_shared<std::string>();
    const auto clear = [shown] {
        if (!shown->empty())
            std::fputs("\r\033[K", stderr);
        shown->clear();
    };
    reporter.before_line = clear;
    reporter.state = [shown, clear](const BatchState& state) {
        if (state.done >= 1 && state.jobs.empty()) {
            clear();
        } else if (const std::string text = bar_text(state); text != *shown) {
            std::fprintf(stderr, "\r%s\033[K", text.c_str());
            *shown = text;
        }
        std::fflush(stderr);
        return !interrupted();
    };
    return reporter;
}

} // namespace integral
