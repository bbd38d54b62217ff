// SPDX-License-Identifier: AGPL-3.0-or-later
// Progress of a batch: finished and remaining pixels, the running jobs, the time left.
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
    double done = 0;                    ///< share of all work, 0 to 1
    std::vector<std::string> jobs;      ///< jobs at work, each once
    std::optional<double> seconds_left; ///< empty while too little is done for an estimate
};

struct JobEnd {
    std::string job;
    bool failed = false;
    double seconds = 0;      ///< time of its steps in this run
    int ended = 0, jobs = 0; ///< ended jobs and all jobs of this run
};

/// Callbacks for the progress of a batch.
struct BatchReporter {
    /// Called several times a second; the batch stops if it returns false.
    std::function<bool(const BatchState& state)> state = [](const BatchState&) { return true; };
    std::function<void(const JobEnd& job)> job_ended = [](const JobEnd&) {};
    /// Called before a line is printed to standard error, to clear a progress bar there.
    std::function<void()> before_line = [] {};
};

/// Adds up the work that a run has to do, in pixels of rendered frames. A step that renders nothing
/// counts as a hundredth of its frame.
class WorkMeter {
public:
    /// `to_do`: indices of steps in the plan; `jobs`: the manifest's jobs. `plan` and `jobs` must
    /// outlive this.
    WorkMeter(const BatchPlan& plan, const std::vector<BatchJob>& jobs,
              const std::list<int>& to_do);

    /// Records the end of a step. Returns the end of its job if this was the job's last step.
    std::optional<JobEnd> end(int step, bool failed, double seconds);

    /// The state after `seconds` of work. `running` maps steps at work to the finished share of
    /// each, 0 to 1.
    BatchState state(const std::map<int, double>& running, double seconds) const;

private:
    struct Job {
        int left = 0; ///< remaining steps
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

/// Copies the output of a program. If a line was overwritten repeatedly, like a progress bar,
/// copies only its last text. Returns whether the copy succeeded.
bool copy_log(const std::string& said, const std::string& log);

} // namespace integral

#endif
