// SPDX-License-Identifier: AGPL-3.0-or-later
// How far a batch is: pixels done and to do, the jobs at work, the time left.
#ifndef INTEGRAL_BATCH_BATCH_PROGRESS_H
#define INTEGRAL_BATCH_BATCH_PROGRESS_H

#include "integral/batch/plan.h"

#include <functional>
#include <list>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace integral {

struct BatchState {
    double done = 0;                    ///< part of all work: 0 to 1
    std::vector<std::string> jobs;      ///< at work, each once
    std::optional<double> seconds_left; ///< nothing while too little is done to tell
};

struct JobEnd {
    std::string job;
    bool failed = false;
    double seconds = 0;      ///< that its steps took in this run
    int ended = 0, jobs = 0; ///< how many jobs of this run have ended, of how many
};

/// Whom a batch tells how it goes on.
struct BatchReporter {
    /// Called several times a second; the batch stops if it returns false.
    std::function<bool(const BatchState& state)> state = [](const BatchState&) { return true; };
    std::function<void(const JobEnd& job)> job_ended = [](const JobEnd&) {};
    /// Called before a line goes to standard error, to clear a bar from it.
    std::function<void()> before_line = [] {};
};

/// Adds up the work of the steps that a run has to do. Work is pixels: those of frames that are
/// rendered; another step counts as a hundredth of its frame's.
class WorkMeter {
public:
    /// `to_do`: indices of steps in the plan, `job_names` of the manifest's jobs. Both must outlive
    /// it.
    WorkMeter(const BatchPlan& plan, const std::vector<BatchJob>& jobs,
              const std::list<int>& to_do);

    /// A step has ended. Returns the end of its job, if this was its last step to do.
    std::optional<JobEnd> end(int step, bool failed, double seconds);

    /// The state after `seconds` of work. `running`: steps at work, and the part of each that is
    /// done, 0 to 1.
    BatchState state(const std::map<int, double>& running, double seconds) const;

private:
    struct Job {
        int left = 0; ///< steps to do
        bool failed = false;
        double seconds = 0;
    };

    double work_of(int step) const;

    const BatchPlan& plan_;
    const std::vector<BatchJob>& names_;
    std::map<int, Job> jobs_;
    double all_ = 0, done_ = 0;
    int ended_ = 0;
};

/// Copies what a program has printed. Of a line that was written over again and again, as progress
/// is, only the last text stays. Returns whether that was possible.
bool copy_log(const std::string& said, const std::string& log);

} // namespace integral

#endif
