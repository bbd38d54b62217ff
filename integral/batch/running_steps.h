// SPDX-License-Identifier: AGPL-3.0-or-later
// The programs that a batch runs concurrently.
#ifndef INTEGRAL_BATCH_RUNNING_STEPS_H
#define INTEGRAL_BATCH_RUNNING_STEPS_H

#include "integral/batch/batch_memory.h"
#include "integral/batch/child_process.h"
#include "integral/batch/lock_file.h"
#include "integral/batch/step_record.h"

#include <chrono>
#include <functional>
#include <list>
#include <vector>

namespace integral {

/// A step whose program is running, or whose output is finished but not yet published.
struct RunningStep {
    using Clock = std::chrono::steady_clock;

    int step; ///< index in the plan
    ChildProcess child;
    LockFile lock;
    StepRecord record;
    double memory; ///< bytes, as forecast
    Clock::time_point begun = Clock::now(), ended{};
    ChildEnd end{}; ///< valid after the program's end
};

class RunningSteps {
public:
    int count() const { return int(running_.size()); }
    bool none() const { return running_.empty(); }
    void add(RunningStep step) { running_.push_back(std::move(step)); }

    std::vector<int> steps() const;

    /// Removes and returns the steps whose programs have ended.
    std::list<RunningStep> take_ended();
    /// The memory of each program.
    std::vector<MemoryUse> memory() const;
    void refresh_locks() const;
    /// Sends SIGTERM to all programs, waits up to five seconds, and kills those still running.
    /// Calls `ended` for each step whose program ended in that time.
    void stop(const std::function<void(int step)>& ended);

private:
    std::list<RunningStep> running_;
};

} // namespace integral

#endif
