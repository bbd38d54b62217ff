// SPDX-License-Identifier: AGPL-3.0-or-later
// What a run of a batch knows of its steps: which are pending, how the others ended, what they have
// made, and what was said of them.
#ifndef INTEGRAL_BATCH_STEP_STATES_H
#define INTEGRAL_BATCH_STEP_STATES_H

#include "integral/batch/batch_folder.h"
#include "integral/batch/batch_progress.h"

#include <set>

namespace integral {

enum class StepFate {
    waiting, ///< not yet looked at, or to be done
    kept,    ///< its output was there already, made of the same inputs
    made,
    copied, ///< another step of the same inputs made it
    failed,
    blocked, ///< its frame failed
};
const char* name_of(StepFate fate);

struct StepResult {
    StepFate fate = StepFate::waiting;
    std::string reason; ///< of a failure
};

/// The states of a plan's steps. A step is named by its index in the plan. Plan and reporter must
/// outlive this.
class StepStates {
public:
    /// Steps of the `jobs` (indices) are pending; of all jobs if `jobs` is empty.
    StepStates(const BatchPlan& plan, const std::set<int>& jobs, const BatchReporter& reporter);

    const BatchStep& step(int i) const { return plan_.steps[std::size_t(i)]; }
    int count() const { return int(plan_.steps.size()); }
    StepFate fate(int i) const { return results_[std::size_t(i)].fate; }
    const std::vector<StepResult>& results() const { return results_; }

    /// A copy of the list of pending steps, in the order in which they are to start.
    std::vector<int> pending() const { return {pending_.begin(), pending_.end()}; }
    bool none_pending() const { return pending_.empty(); }
    /// How many pending steps other than `i` could start at once.
    int ready_beside(int i) const;

    /// Whether the frame that a step reads is there, or the step reads none.
    bool has_its_frame(const BatchStep& step) const;
    /// The hash of the frame that a step reads; "" if it reads none. The frame must be there.
    std::string frame_hash(const BatchStep& step) const;

    /// The step that makes, or has made, the output of these inputs.
    std::optional<int> maker(const std::string& inputs_hash) const;
    bool has_output(int i) const { return outputs_.count(i) > 0; }

    /// Sorts the pending steps, and begins to report the ends of jobs. `jobs` must outlive this.
    void begin(const std::vector<BatchJob>& jobs, const BatchFolder& folder);
    /// How far the work is; see WorkMeter::state. Only after begin.
    BatchState work(const std::map<int, double>& running, double seconds) const;

    /// A pending step's program starts, so the step is no longer pending.
    void set_running(int i, const std::string& inputs_hash);
    void set_finished(int i, StepFate fate, const StepRecord& record);
    /// Also blocks the steps that read what this one should have made.
    void set_failed(int i, const std::string& reason);
    /// Puts a step whose program has failed first among the pending ones.
    void set_pending_again(int i) { pending_.push_front(i); }

    /// Says a line of a step on standard error; say_once, unless it was the last that say_once
    /// said of that step.
    void say(int i, const std::string& what) const;
    void say_once(int i, const std::string& what);

private:
    StepResult& result(int i) { return results_[std::size_t(i)]; }
    void count_end(int i, bool failed, double seconds);

    const BatchPlan& plan_;
    const BatchReporter& reporter_;
    std::vector<StepResult> results_;
    std::vector<std::string> said_; ///< what was last said of each step that waits
    std::list<int> pending_;
    std::map<int, std::string> outputs_;   ///< hashes of finished steps' outputs
    std::map<std::string, int> by_inputs_; ///< by hash of inputs, the step that makes or has made
                                           ///< the output of them
    std::optional<WorkMeter> meter_;       ///< of what this run has to do
};

} // namespace integral

#endif
