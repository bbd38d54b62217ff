// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/batch_progress.h"

#include "integral/batch/batch_steps.h"

#include <algorithm>
#include <fstream>

namespace integral {

WorkMeter::WorkMeter(const BatchPlan& plan, const std::vector<BatchJob>& jobs,
                     const std::list<int>& to_do)
    : plan_(plan), names_(jobs)
{
    for (const int step : to_do) {
        all_ += work_of(step);
        ++jobs_[plan_.steps[std::size_t(step)].job].left;
    }
}

double WorkMeter::work_of(int index) const
{
    constexpr double part_of_frame = 0.01;
    const BatchStep& step = plan_.steps[std::size_t(index)];
    return step.frame < 0 ? pixels_of(step, "")
                          : part_of_frame * pixels_of(plan_.steps[std::size_t(step.frame)], "");
}

std::optional<JobEnd> WorkMeter::end(int step, bool failed, double seconds)
{
    done_ += work_of(step);
    const int number = plan_.steps[std::size_t(step)].job;
    Job& job = jobs_[number];
    job.failed = job.failed || failed;
    job.seconds += seconds;
    if (--job.left > 0)
        return std::nullopt;
    ++ended_;
    return JobEnd{names_[std::size_t(number)].name, job.failed, job.seconds, ended_,
                  int(jobs_.size())};
}

BatchState WorkMeter::state(const std::map<int, double>& running, double seconds) const
{
    constexpr double least_part = 0.01, least_seconds = 2;
    BatchState state;
    double done = done_;
    for (const auto& [step, part] : running) {
        done += part * work_of(step);
        const std::string& job = names_[std::size_t(plan_.steps[std::size_t(step)].job)].name;
        if (std::find(state.jobs.begin(), state.jobs.end(), job) == state.jobs.end())
            state.jobs.push_back(job);
    }
    state.done = all_ > 0 ? std::min(1.0, done / all_) : 1;
    if (state.done >= least_part && seconds >= least_seconds)
        state.seconds_left = seconds * (1 - state.done) / state.done;
    return state;
}

bool copy_log(const std::string& said, const std::string& log)
{
    std::ifstream from(said, std::ios::binary);
    std::ofstream to(log, std::ios::binary | std::ios::trunc);
    for (std::string line; std::getline(from, line);) {
        while (!line.empty() && line.back() == '\r')
            line.pop_back();
        const auto over = line.rfind('\r');
        to << (over == std::string::npos ? line : line.substr(over + 1)) << '\n';
    }
    to.close();
    return bool(to);
}

} // namespace integral
