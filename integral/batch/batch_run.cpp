// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/batch_run.h"

#include "integral/base/file_bytes.h"
#include "integral/base/interrupt.h"
#include "integral/base/message_text.h"
#include "integral/batch/batch_schedule.h"
#include "integral/batch/batch_steps.h"
#include "integral/batch/renderer.h"
#include "integral/batch/running_steps.h"

#include <csignal>
#include <filesystem>
#include <poll.h>
#include <unistd.h>

namespace integral {
namespace {

using Clock = RunningStep::Clock;
constexpr int poll_milliseconds = 5;
constexpr auto look_after = std::chrono::milliseconds(200); ///< whether a waiting step can start
constexpr auto refresh_after = std::chrono::seconds(10);    ///< locks

bool exists(const std::string& path) { return access(path.c_str(), F_OK) == 0; }

class Run {
public:
    Run(PlannedBatch& batch, const BatchPlan& plan, const RunOptions& options,
        const BatchReporter& reporter)
        : plan_(plan),
          jobs_(batch.manifest.jobs),
          reporter_(reporter),
          inputs_(batch.inputs),
          options_(options),
          folder_(batch.folder),
          results_(plan.steps.size()),
          tries_(plan.steps.size()),
          said_(plan.steps.size()),
          memory_(batch.manifest, options.memory, options.output_pixels)
    {
        for (std::size_t i = 0; i < plan.steps.size(); ++i)
            if (options.jobs.empty() || options.jobs.count(plan.steps[i].job))
                pending_.push_back(int(i));
    }

    /// Finishes those pending steps that are done already.
    void keep_done()
    {
        for (const int i : pending_) {
            stop_if_interrupted();
            const BatchStep& step = step_at(i);
            if (step.frame >= 0 && result(step.frame).fate != StepFate::kept)
                continue;
            try {
                const StepRecord record = read_record(folder_.record(step));
                if (is_done(folder_, step, record, inputs_.hash(step, frame_hash(step))))
                    set_finished(i, StepFate::kept, record);
            } catch (const InputError&) { // is said when the step is started
            }
        }
        pending_.remove_if([&](int i) { return result(i).fate == StepFate::kept; });
    }

    void run()
    {
        struct sigaction wake = {};
        wake.sa_handler = [](int) {};
        sigaction(SIGCHLD, &wake, nullptr);
        keep_done();
        tidy_up();
        sort_longest_first(pending_, plan_, folder_);
        meter_.emplace(plan_, jobs_, pending_);
        begun_ = Clock::now();
        BatchState state = meter_->state({}, 0);
        auto next_look = Clock::now(), next_refresh = Clock::now() + refresh_after;
        while (!pending_.empty() || !running_.none()) {
            if (!reporter_.state(state))
                stop_all();
            std::list<RunningStep> ended = running_.take_ended();
            const bool any_ended = !ended.empty();
            if (any_ended || Clock::now() >= next_look) {
                start_some(ended); // so that the cores work while outputs are hashed and published
                conclude(ended);
                start_some(ended);
                state = state_now();
                next_look = Clock::now() + look_after;
            }
            if (Clock::now() >= next_refresh) {
                running_.refresh_locks();
                batch_lock.refresh();
                next_refresh = Clock::now() + refresh_after;
            }
            if (!any_ended)
                poll(nullptr, 0, poll_milliseconds); // SIGCHLD interrupts it
        }
        reporter_.state(meter_->state({}, 0));
    }

    std::vector<StepResult> results() const { return results_; }

    LockFile batch_lock; ///< of the whole folder, when all jobs are run

private:
    const BatchStep& step_at(int i) const { return plan_.steps[std::size_t(i)]; }
    StepResult& result(int i) { return results_[std::size_t(i)]; }

    /// The hash and the path of the frame that a step reads; "" if it reads none.
    std::string frame_hash(const BatchStep& step) const
    {
        return step.frame < 0 ? "" : outputs_.at(step.frame);
    }
    std::string frame_path(const BatchStep& step) const
    {
        return step.frame < 0 ? "" : folder_.output(step_at(step.frame));
    }

    bool has_its_frame(const BatchStep& step) const
    {
        return step.frame < 0 || outputs_.count(step.frame);
    }

    void set_finished(int i, StepFate fate, const StepRecord& record)
    {
        by_inputs_.emplace(record.inputs, i);
        result(i).fate = fate;
        outputs_[i] = record.output;
    }

    void finish(int i, StepFate fate, const StepRecord& record)
    {
        set_finished(i, fate, record);
        pending_.remove(i);
        count_end(i, false, fate == StepFate::made ? record.seconds : 0);
    }

    /// Notes that a step has ended, and tells of its job if that has.
    void count_end(int i, bool failed, double seconds)
    {
        if (const auto job = meter_->end(i, failed, seconds))
            reporter_.job_ended(*job);
    }

    BatchState state_now() const
    {
        std::map<int, double> parts;
        for (const int i : running_.steps())
            parts[i] = step_at(i).frame < 0 ? rendered_part(said_file(step_at(i))) : 0;
        return meter_->state(parts, std::chrono::duration<double>(Clock::now() - begun_).count());
    }

    /// Deletes what batches that were killed have left: working folders of steps that are done, and
    /// unfinished files.
    void tidy_up()
    {
        for (const char* const own : {"", "/.integral-batch/locks", "/.integral-batch/steps",
                                      "/.integral-batch/strips", "/.integral-batch/slurm"})
            sweep_unfinished(folder_.path + own);
        for (std::size_t i = 0; i < plan_.steps.size(); ++i) {
            const BatchStep& step = plan_.steps[i];
            LockFile lock;
            std::string holder;
            if (results_[i].fate == StepFate::kept &&
                (exists(folder_.work(step)) || exists(folder_.lock(step.name))) &&
                lock.take(folder_.lock(step.name), holder))
                clean(step);
        }
    }

    void fail(int i, const std::string& reason)
    {
        const BatchStep& step = step_at(i);
        result(i) = {StepFate::failed, reason};
        pending_.remove(i);
        const bool log = exists(folder_.log(step));
        say(i, reason + (log ? "; see " + folder_.log(step) : ""));
        count_end(i, true, 0);
        pending_.remove_if([&](int other) {
            if (step_at(other).frame != i)
                return false;
            result(other) = {StepFate::blocked, "its frame failed"};
            count_end(other, true, 0);
            return true;
        });
    }

    void say_once(int i, const std::string& what)
    {
        if (said_[std::size_t(i)] == what)
            return;
        said_[std::size_t(i)] = what;
        say(i, what);
    }

    void say(int i, const std::string& what) const
    {
        reporter_.before_line();
        integral::say("batch", step_at(i).name + ": " + what);
    }

    void say_remark(int i, const StepRecord& record) const
    {
        if (!record.remark.empty())
            say(i, record.remark);
    }

    /// Starts steps while there are cores and memory for them. If interrupted, publishes `ended`,
    /// stops and throws.
    void start_some(std::list<RunningStep>& ended)
    {
        for (const int i : std::vector<int>(pending_.begin(), pending_.end())) {
            if (running_.count() >= options_.at_once)
                return;
            if (result(i).fate != StepFate::waiting || !has_its_frame(step_at(i)))
                continue;
            if (interrupted()) {
                conclude(ended);
                stop_all();
            }
            try {
                start(i);
            } catch (const InputError& error) {
                fail(i, error.what());
            } catch (const OutputError& error) {
                fail(i, error.what());
            }
        }
    }

    /// Starts a step, or finishes it without its program if it is done or another has made the
    /// same; leaves it pending if it has to wait.
    void start(int i)
    {
        const BatchStep& step = step_at(i);
        const std::string frame = frame_path(step);
        const std::string hash = inputs_.hash(step, frame_hash(step));
        StepRecord record = read_record(folder_.record(step));
        if (is_done(folder_, step, record, hash))
            return finish(i, StepFate::kept, record);
        const auto twin = by_inputs_.find(hash);
        if (twin != by_inputs_.end() && twin->second != i &&
            result(twin->second).fate == StepFate::waiting)
            return; // the other one is running
        const double pixels = pixels_of(step, frame),
                     memory = memory_.expected(step, frame, pixels, record);
        const bool copies = twin != by_inputs_.end() && outputs_.count(twin->second);
        if (!copies && !has_memory(i, memory))
            return;
        LockFile lock;
        std::string holder;
        if (!lock.take(folder_.lock(step.name), holder))
            return say_once(i, "waits for " + holder + ", which makes it");
        record = read_record(folder_.record(step));
        if (is_done(folder_, step, record, hash))
            return finish(i, StepFate::kept, record);
        record.inputs = hash;
        record.pixels = pixels;
        record.error.reset();
        record.remark.clear();
        clean(step);
        std::error_code ignored;
        std::filesystem::create_directories(folder_.work(step), ignored);
        if (copies)
            copy(i, twin->second, record);
        else
            start_program(i, std::move(lock), record, memory);
    }

    void start_program(int i, LockFile lock, StepRecord record, double memory)
    {
        const BatchStep& step = step_at(i);
        by_inputs_[record.inputs] = i;
        record.state = StepState::running;
        ++record.starts;
        record.output.clear();
        write_record(folder_.record(step), record);
        const int threads = threads_beside(others_beside(i), options_.at_once);
        ChildProcess child(command_line(folder_, step, frame_path(step), threads), step.folder,
                           said_file(step));
        pending_.remove(i);
        running_.add({i, std::move(child), std::move(lock), record, memory});
    }

    void copy(int i, int twin, StepRecord record)
    {
        const BatchStep& step = step_at(i);
        publish_copy(folder_, step, step_at(twin), record);
        clean(step);
        say_remark(i, record);
        finish(i, StepFate::copied, read_record(folder_.record(step)));
    }

    /// How many other steps could start as well.
    int others_beside(int i) const
    {
        int others = 0;
        for (const int other : pending_)
            others += other != i && has_its_frame(step_at(other));
        return others;
    }

    /// Whether a step can have that much memory now. Says why not; it fails if nothing else runs.
    bool has_memory(int i, double needed)
    {
        const std::string lack = memory_.lack(needed, running_.memory());
        if (lack.empty())
            return true;
        if (running_.none())
            fail(i, lack + "; --memory MB gives it more");
        else
            say_once(i, lack + ": it waits");
        return false;
    }

    /// Publishes what programs that have ended have made, or notes their failures.
    void conclude(std::list<RunningStep>& ended)
    {
        for (; !ended.empty(); ended.pop_front())
            conclude(ended.front());
    }

    void conclude(RunningStep& one)
    {
        const BatchStep& step = step_at(one.step);
        StepRecord& record = one.record;
        record.seconds = std::chrono::duration<double>(one.ended - one.begun).count();
        const std::string reason = publish_made(folder_, step, frame_path(step), said_file(step),
                                                one.end, record);
        if (!reason.empty())
            return conclude_failed(one.step, record, reason);
        memory_.learn(step, frame_path(step), record);
        std::error_code ignored;
        std::filesystem::remove(folder_.log(step), ignored);
        clean(step);
        say_remark(one.step, record);
        finish(one.step, StepFate::made, read_record(folder_.record(step)));
    }

    void conclude_failed(int i, StepRecord record, const std::string& reason)
    {
        const BatchStep& step = step_at(i);
        if (interrupted()) // that is why it failed: there is nothing to keep
            return clean(step);
        std::error_code ignored;
        if (!copy_log(said_file(step), folder_.log(step))) // half a log says less than none
            std::filesystem::remove(folder_.log(step), ignored);
        clean(step);
        record.state = StepState::failed;
        record.reason = reason;
        try {
            write_record(folder_.record(step), record);
        } catch (const OutputError&) { // the reason is said below, and the old record does not call
                                       // the step done
        }
        if (++tries_[std::size_t(i)] > options_.retries || interrupted())
            return fail(i, reason);
        say(i, reason + "; it is tried again");
        pending_.push_front(i);
    }

    /// What a running step's program says.
    std::string said_file(const BatchStep& step) const { return folder_.work(step) + "/said.txt"; }

    void clean(const BatchStep& step)
    {
        std::error_code ignored;
        std::filesystem::remove_all(folder_.work(step), ignored);
    }

    [[noreturn]] void stop_all()
    {
        running_.stop([&](int i) { clean(step_at(i)); });
        throw Interrupted();
    }

    const BatchPlan& plan_;
    const std::vector<BatchJob>& jobs_;
    const BatchReporter& reporter_;
    StepInputs& inputs_;
    const RunOptions& options_;
    const BatchFolder& folder_;
    std::vector<StepResult> results_;
    std::vector<int> tries_;
    std::vector<std::string> said_; ///< what was last said of each step that waits
    std::list<int> pending_;
    RunningSteps running_;
    std::map<int, std::string> outputs_;   ///< hashes of finished steps' outputs
    std::map<std::string, int> by_inputs_; ///< by hash of inputs, the step that makes or has made
                                           ///< the output of them
    MemoryForecast memory_;
    std::optional<WorkMeter> meter_; ///< of what this run has to do
    Clock::time_point begun_;
};

} // namespace

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

std::vector<StepResult> survey(PlannedBatch& batch, const RunOptions& options)
{
    const BatchReporter nobody;
    Run run(batch, batch.plan, options, nobody);
    run.keep_done();
    return run.results();
}

std::vector<StepResult> run_batch(PlannedBatch& batch, const RunOptions& options,
                                  const BatchReporter& reporter)
{
    return run_steps(batch, batch.plan, options, reporter);
}

std::vector<StepResult> run_steps(PlannedBatch& batch, const BatchPlan& plan,
                                  const RunOptions& options, const BatchReporter& reporter)
{
    make_batch_folder(batch.manifest.output, plan);
    Run run(batch, plan, options, reporter);
    std::string holder;
    if (options.jobs.empty() && !run.batch_lock.take(batch.folder.lock("batch"), holder))
        throw OutputError(
            batch.manifest.output + ": another batch, " + holder +
            ", works in this folder; wait for it, or give this manifest another \"output\"");
    run.run();
    return run.results();
}

} // namespace integral
