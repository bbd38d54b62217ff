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
constexpr auto look_after = std::chrono::milliseconds(200); ///< between checks for ready steps
constexpr auto refresh_after = std::chrono::seconds(10);    ///< between refreshes of locks

bool exists(const std::string& path) { return access(path.c_str(), F_OK) == 0; }

class Run {
public:
    Run(PlannedBatch& batch, const BatchPlan& plan, const RunOptions& options,
        const BatchReporter& reporter)
        : jobs_(batch.manifest.jobs),
          reporter_(reporter),
          inputs_(batch.inputs),
          options_(options),
          folder_(batch.folder),
          states_(plan, options.jobs, reporter),
          tries_(plan.steps.size()),
          memory_(batch.manifest, options.memory, options.output_pixels)
    {
    }

    /// Finishes the pending steps whose output exists already.
    void keep_done()
    {
        for (const int i : states_.pending()) {
            stop_if_interrupted();
            const BatchStep& step = states_.step(i);
            if (step.frame >= 0 && states_.fate(step.frame) != StepFate::kept)
                continue;
            try {
                const StepRecord record = read_record(folder_.record(step));
                if (is_done(folder_, step, record, inputs_.hash(step, states_.frame_hash(step))))
                    states_.set_finished(i, StepFate::kept, record);
            } catch (const InputError&) { // reported when the step is started
            }
        }
    }

    void run()
    {
        struct sigaction wake = {};
        wake.sa_handler = [](int) {};
        sigaction(SIGCHLD, &wake, nullptr);
        keep_done();
        tidy_up();
        states_.begin(jobs_, folder_);
        begun_ = Clock::now();
        BatchState state = states_.work({}, 0);
        auto next_look = Clock::now(), next_refresh = Clock::now() + refresh_after;
        while (!states_.none_pending() || !running_.none()) {
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
        reporter_.state(states_.work({}, 0));
    }

    std::vector<StepResult> results() const { return states_.results(); }

    LockFile batch_lock; ///< on the whole folder, taken when all jobs are run

private:
    /// The path of the frame that a step reads; "" if it reads none.
    std::string frame_path(const BatchStep& step) const
    {
        return step.frame < 0 ? "" : folder_.output(states_.step(step.frame));
    }

    BatchState state_now() const
    {
        std::map<int, double> parts;
        for (const int i : running_.steps())
            parts[i] = states_.step(i).frame < 0 ? rendered_part(said_file(states_.step(i))) : 0;
        return states_.work(parts, std::chrono::duration<double>(Clock::now() - begun_).count());
    }

    /// Deletes the leftovers of killed batches: working folders and failure logs of finished steps,
    /// and unfinished files.
    void tidy_up()
    {
        for (const char* const own : {"", "/.integral-batch/locks", "/.integral-batch/steps",
                                      "/.integral-batch/strips", "/.integral-batch/slurm"})
            sweep_unfinished(folder_.path + own);
        for (int i = 0; i < states_.count(); ++i) {
            const BatchStep& step = states_.step(i);
            LockFile lock;
            std::string holder;
            if (states_.fate(i) == StepFate::kept &&
                (exists(folder_.work(step)) || exists(folder_.log(step)) ||
                 exists(folder_.lock(step.name))) &&
                lock.take(folder_.lock(step.name), holder))
                clean_done(step);
        }
    }

    void fail(int i, const std::string& reason)
    {
        const std::string log = folder_.log(states_.step(i));
        states_.say(i, reason + (exists(log) ? "; see " + log : ""));
        states_.set_failed(i, reason);
    }

    void say_remark(int i, const StepRecord& record) const
    {
        if (!record.remark.empty())
            states_.say(i, record.remark);
    }

    /// Starts steps while cores and memory suffice. If interrupted, publishes `ended`, stops and
    /// throws.
    void start_some(std::list<RunningStep>& ended)
    {
        for (const int i : states_.pending()) {
            if (running_.count() >= options_.at_once)
                return;
            if (states_.fate(i) != StepFate::waiting || !states_.has_its_frame(states_.step(i)))
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

    /// Starts a step's program. If the output exists, or another step has made the same output,
    /// finishes the step without a program. Leaves the step pending if it has to wait.
    void start(int i)
    {
        const BatchStep& step = states_.step(i);
        const std::string frame = frame_path(step);
        const std::string hash = inputs_.hash(step, states_.frame_hash(step));
        StepRecord record = read_record(folder_.record(step));
        if (is_done(folder_, step, record, hash))
            return states_.set_finished(i, StepFate::kept, record);
        const std::optional<int> twin = states_.maker(hash);
        if (twin && *twin != i && states_.fate(*twin) == StepFate::waiting)
            return; // the other step's program is still running
        const double pixels = pixels_of(step, frame),
                     memory = memory_.expected(step, frame, pixels, record);
        const bool copies = twin && states_.has_output(*twin);
        if (!copies && !has_memory(i, memory))
            return;
        LockFile lock;
        std::string holder;
        if (!lock.take(folder_.lock(step.name), holder))
            return states_.say_once(i, "waits for " + holder + ", which makes it");
        record = read_record(folder_.record(step));
        if (is_done(folder_, step, record, hash)) {
            clean_done(step);
            return states_.set_finished(i, StepFate::kept, record);
        }
        record.inputs = hash;
        record.pixels = pixels;
        record.error.reset();
        record.remark.clear();
        clean(step);
        std::error_code ignored;
        std::filesystem::create_directories(folder_.work(step), ignored);
        if (copies)
            copy(i, *twin, record);
        else
            start_program(i, std::move(lock), record, memory);
    }

    void start_program(int i, LockFile lock, StepRecord record, double memory)
    {
        const BatchStep& step = states_.step(i);
        states_.set_running(i, record.inputs);
        record.state = StepState::running;
        ++record.starts;
        record.output.clear();
        write_record(folder_.record(step), record);
        const int threads = threads_beside(states_.ready_beside(i), options_.at_once);
        ChildProcess child(command_line(folder_, step, frame_path(step), threads), step.folder,
                           said_file(step));
        running_.add({i, std::move(child), std::move(lock), record, memory});
    }

    void copy(int i, int twin, StepRecord record)
    {
        const BatchStep& step = states_.step(i);
        publish_copy(folder_, step, states_.step(twin), record);
        clean_done(step);
        say_remark(i, record);
        states_.set_finished(i, StepFate::copied, read_record(folder_.record(step)));
    }

    /// Whether `needed` bytes are free. Reports a lack; if no program runs, the step then fails.
    bool has_memory(int i, double needed)
    {
        const std::string lack = memory_.lack(needed, running_.memory());
        if (lack.empty())
            return true;
        if (running_.none())
            fail(i, lack + "; --memory MB gives it more");
        else
            states_.say_once(i, lack + ": it waits");
        return false;
    }

    /// Publishes the results of ended programs, or records their failures.
    void conclude(std::list<RunningStep>& ended)
    {
        for (; !ended.empty(); ended.pop_front())
            conclude(ended.front());
    }

    void conclude(RunningStep& one)
    {
        const BatchStep& step = states_.step(one.step);
        StepRecord& record = one.record;
        record.seconds = std::chrono::duration<double>(one.ended - one.begun).count();
        const std::string reason = publish_made(folder_, step, frame_path(step), said_file(step),
                                                one.end, record);
        if (!reason.empty())
            return conclude_failed(one.step, record, reason);
        memory_.learn(step, frame_path(step), record);
        clean_done(step);
        say_remark(one.step, record);
        states_.set_finished(one.step, StepFate::made, read_record(folder_.record(step)));
    }

    void conclude_failed(int i, StepRecord record, const std::string& reason)
    {
        const BatchStep& step = states_.step(i);
        if (interrupted()) // the cause of the failure: there is nothing to keep
            return clean(step);
        std::error_code ignored;
        if (!copy_log(said_file(step), folder_.log(step))) // an incomplete log would mislead
            std::filesystem::remove(folder_.log(step), ignored);
        clean(step);
        record.state = StepState::failed;
        record.reason = reason;
        try {
            write_record(folder_.record(step), record);
        } catch (const OutputError&) { // the reason is reported below, and the old record does not
                                       // mark the step as done
        }
        if (++tries_[std::size_t(i)] > options_.retries || interrupted())
            return fail(i, reason);
        states_.say(i, reason + "; it is tried again");
        states_.set_pending_again(i);
    }

    /// The file for a running program's output.
    std::string said_file(const BatchStep& step) const { return folder_.work(step) + "/said.txt"; }

    /// Deletes the working folder of a step.
    void clean(const BatchStep& step)
    {
        std::error_code ignored;
        std::filesystem::remove_all(folder_.work(step), ignored);
    }

    /// Deletes a finished step's working folder, and the log of an earlier failure.
    void clean_done(const BatchStep& step)
    {
        std::error_code ignored;
        std::filesystem::remove(folder_.log(step), ignored);
        clean(step);
    }

    [[noreturn]] void stop_all()
    {
        running_.stop([&](int i) { clean(states_.step(i)); });
        throw Interrupted();
    }

    const std::vector<BatchJob>& jobs_;
    const BatchReporter& reporter_;
    StepInputs& inputs_;
    const RunOptions& options_;
    const BatchFolder& folder_;
    StepStates states_;
    std::vector<int> tries_;
    RunningSteps running_;
    MemoryForecast memory_;
    Clock::time_point begun_;
};

} // namespace

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
