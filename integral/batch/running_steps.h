// SPDX-License-Identifier: AGPL-3.0-or-later
// The programs that a batch runs at one time.
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

/// A step whose program runs, or has ended and is not yet published.
struct RunningStep {
    using Clock = std::chrono::steady_clock;

    int step; ///< in the plan
    ChildProcess child;
    LockFile lock;
    StepRecord record;
    double memory; ///< bytes that it is expected to take
    Clock::time_point begun = Clock::now(), ended{};
    ChildEnd end{}; ///< how it ended, once it has
};

class RunningSteps {
public:
    int count() const { return int(running_.size()); }
    bool none() const { return running_.empty(); }
    void add(RunningStep step) { running_.push_back(std::move(step)); }

    std::vector<int> steps() const;

    /// Looks which programs have ended since; they are no longer counted.
    std::list<RunningStep> take_ended();
    /// What each of the programs takes.
    std::vector<MemoryUse> memory() const;
    void refresh_locks() const;
    /// Asks all to end, gives them five seconds, and kills the rest. Calls `ended` for each step
    /// whose program has ended when asked.
    void stop(const std::function<void(int step)>& ended);

private:
    std::list<RunningStep> running_;
};

} // namespace integral

#endif
