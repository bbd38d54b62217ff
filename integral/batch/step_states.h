// SPDX-License-Identifier: AGPL-3.0-or-later
// The states of a batch's steps during a run: which steps are pending, how the finished steps
// ended, what they made, and what was reported.
#ifndef INTEGRAL_BATCH_STEP_STATES_H
#define INTEGRAL_BATCH_STEP_STATES_H

#include "integral/batch/batch_folder.h"
#include "integral/batch/batch_progress.h"

#include <set>

namespace integral {

enum class StepFate {
    waiting, ///< not yet examined, or to be done
    kept,    ///< its output existed already, from the same inputs
    made,
    copied, ///< another step made the output from the same inputs
    failed,
    blocked, ///< its frame failed
};
const char* name_of(StepFate fate);

struct StepResult {
    StepFate fate = StepFate::waiting;
    std::string reason; ///< of a failure
};

/// States of a plan's steps. A step is identified by its index in the plan. Plan and reporter must
/// outlive this.
class StepStates {
public:
    /// The steps of `jobs` (indices) are pending; all steps if `jobs` is empty.
    StepStates(const BatchPlan& plan, const std::set<int>& jobs, const BatchReporter& reporter);

    const BatchStep& step(int i) const { return plan_.steps[std::size_t(i)]; }
    int count() const { return int(plan_.steps.size()); }
    StepFate fate(int i) const { return results_[std::size_t(i)].fate; }
    const std::vector<StepResult>& results() const { return results_; }

    /// A copy of the list of pending steps, in starting order.
    std::vector<int> pending() const { return {pending_.begin(), pending_.end()}; }
    bool none_pending() const { return pending_.empty(); }
    /// Number of pending steps other than `i` that could start now.
    int ready_beside(int i) const;

    /// Whether the frame that a step reads is ready; true if it reads none.
    bool has_its_frame(const BatchStep& step) const;
    /// The hash of the frame that a step reads; "" if it reads none. The frame must be ready.
    std::string frame_hash(const BatchStep& step) const;

    /// The step that makes, or has made, the output from these inputs.
    std::optional<int> maker(const std::string& inputs_hash) const;
    bool has_output(int i) const { return outputs_.count(i) > 0; }

    /// Sorts the pending steps, and begins to report the ends of jobs. `jobs` must outlive this.
    void begin(const std::vector<BatchJob>& jobs, const BatchFolder& folder);
    /// Progress of the work; see WorkMeter::state. Only after begin.
    BatchState work(const std::map<int, double>& running, double seconds) const;

    /// Removes a step from the pending ones, as its program starts.
    void set_running(int i, const std::string& inputs_hash);
    void set_finished(int i, StepFate fate, const StepRecord& record);
    /// Also blocks the steps that read this step's output.
    void set_failed(int i, const std::string& reason);
    /// Puts a step whose program has failed back, before all pending steps.
    void set_pending_again(int i) { pending_.push_front(i); }

    /// Prints a line about a step to standard error; say_once omits a line that equals its last
    /// line for that step.
    void say(int i, const std::string& what) const;
    void say_once(int i, const std::string& what);

private:
    StepResult& result(int i) { return results_[std::size_t(i)]; }
    void count_end(int i, bool failed, double seconds);

    const BatchPlan& plan_;
    const BatchReporter& reporter_;
    std::vector<StepResult> results_;
    std::vector<std::string> said_; ///< for each step, the last line of say_once
    std::list<int> pending_;
    std::map<int, std::string> outputs_;   ///< hashes of finished steps' outputs
    std::map<std::string, int> by_inputs_; ///< hash of inputs to the step that makes or has made
                                           ///< the output
    std::optional<WorkMeter> meter_;       ///< of this run's work
};

} // namespace integral

#endif
