// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/step_states.h"

#include "integral/base/message_text.h"
#include "integral/batch/batch_schedule.h"

namespace integral {

const char* name_of(StepFate fate)
{
    switch (fate) {
    case StepFate::kept: return "kept";
    case StepFate::made: return "made";
    case StepFate::copied: return "copied";
    case StepFate::failed: return "failed";
    case StepFate::blocked: return "blocked";
    case StepFate::waiting: break;
    }
    return "waiting";
}

StepStates::StepStates(const BatchPlan& plan, const std::set<int>& jobs,
                       const BatchReporter& reporter)
    : plan_(plan), reporter_(reporter), results_(plan.steps.size()), said_(plan.steps.size())
{
    for (int i = 0; i < count(); ++i)
        if (jobs.empty() || jobs.count(step(i).job))
            pending_.push_back(i);
}

int StepStates::ready_beside(int i) const
{
    int others = 0;
    for (const int other : pending_)
        others += other != i && has_its_frame(step(other));
    return others;
}

bool StepStates::has_its_frame(const BatchStep& step) const
{
    return step.frame < 0 || has_output(step.frame);
}

std::string StepStates::frame_hash(const BatchStep& step) const
{
    return step.frame < 0 ? "" : outputs_.at(step.frame);
}

std::optional<int> StepStates::maker(const std::string& inputs_hash) const
{
    const auto found = by_inputs_.find(inputs_hash);
    return found == by_inputs_.end() ? std::nullopt : std::optional(found->second);
}

void StepStates::begin(const std::vector<BatchJob>& jobs, const BatchFolder& folder)
{
    sort_longest_first(pending_, plan_, folder);
    meter_.emplace(plan_, jobs, pending_);
}

BatchState StepStates::work(const std::map<int, double>& running, double seconds) const
{
    return meter_->state(running, seconds);
}

void StepStates::set_running(int i, const std::string& inputs_hash)
{
    by_inputs_[inputs_hash] = i;
    pending_.remove(i);
}

void StepStates::set_finished(int i, StepFate fate, const StepRecord& record)
{
    by_inputs_.emplace(record.inputs, i);
    result(i).fate = fate;
    outputs_[i] = record.output;
    pending_.remove(i);
    count_end(i, false, fate == StepFate::made ? record.seconds : 0);
}

void StepStates::set_failed(int i, const std::string& reason)
{
    result(i) = {StepFate::failed, reason};
    pending_.remove(i);
    count_end(i, true, 0);
    pending_.remove_if([&](int other) {
        if (step(other).frame != i)
            return false;
        result(other) = {StepFate::blocked, "its frame failed"};
        count_end(other, true, 0);
        return true;
    });
}

/// Counts the end of a step, and reports the end of its job if this was the last step.
void StepStates::count_end(int i, bool failed, double seconds)
{
    if (!meter_)
        return;
    if (const auto job = meter_->end(i, failed, seconds))
        reporter_.job_ended(*job);
}

void StepStates::say(int i, const std::string& what) const
{
    reporter_.before_line();
    integral::say("batch", step(i).name + ": " + what);
}

void StepStates::say_once(int i, const std::string& what)
{
    if (said_[std::size_t(i)] == what)
        return;
    said_[std::size_t(i)] = what;
    say(i, what);
}

} // namespace integral
