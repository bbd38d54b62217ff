// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/running_steps.h"

#include <poll.h>

namespace integral {
namespace {

using Clock = RunningStep::Clock;
constexpr auto patience = std::chrono::seconds(5);
constexpr int poll_milliseconds = 5;

} // namespace

std::vector<int> RunningSteps::steps() const
{
    std::vector<int> steps;
    for (const RunningStep& one : running_)
        steps.push_back(one.step);
    return steps;
}

std::list<RunningStep> RunningSteps::take_ended()
{
    std::list<RunningStep> ended;
    for (auto it = running_.begin(); it != running_.end();) {
        const auto next = std::next(it);
        if (const auto end = it->child.ended()) {
            it->end = *end;
            it->ended = Clock::now();
            ended.splice(ended.end(), running_, it);
        }
        it = next;
    }
    return ended;
}

std::vector<MemoryUse> RunningSteps::memory() const
{
    std::vector<MemoryUse> uses;
    for (const RunningStep& one : running_)
        uses.push_back({one.memory, one.child.memory_now()});
    return uses;
}

void RunningSteps::refresh_locks() const
{
    for (const RunningStep& one : running_)
        one.lock.refresh();
}

void RunningSteps::stop(const std::function<void(int step)>& ended)
{
    for (RunningStep& one : running_)
        one.child.stop();
    const auto until = Clock::now() + patience;
    while (!running_.empty() && Clock::now() < until) {
        for (auto it = running_.begin(); it != running_.end();)
            if (it->child.ended()) {
                ended(it->step);
                it = running_.erase(it);
            } else {
                ++it;
            }
        poll(nullptr, 0, poll_milliseconds);
    }
    running_.clear(); // kills the remaining programs
}

} // namespace integral
