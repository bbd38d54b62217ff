// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/batch_run.h"

#include "integral/base/file_bytes.h"
#include "integral/base/interrupt.h"
#include "integral/base/message_text.h"
#include "integral/batch/batch_memory.h"
#include "integral/batch/batch_schedule.h"
#include "integral/batch/batch_steps.h"
#include "integral/batch/lock_file.h"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <list>
#include <poll.h>
#include <unistd.h>

namespace integral {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int poll_milliseconds = 5;
constexpr auto again_after = std::chrono::milliseconds(200);
constexpr auto patience = std::chrono::seconds(5), refresh_after = std::chrono::seconds(10);

class Run {
public:
    Run(const Manifest& manifest, const BatchPlan& plan, StepInputs& inputs,
        const RunOptions& options, const BatchFolder& folder)
        : plan_(plan),
          inputs_(inputs),
          options_(options),
          folder_(folder),
          results_(plan.steps.size()),
          tries_(plan.steps.size()),
          said_(plan.steps.size()),
          memory_(manifest, options.memory, options.output_pixels)
    {
        for (std::size_t i = 0; i < plan.steps.size(); ++i)
            if (options.jobs.empty() || options.jobs.count(plan.steps[i].job))
                pending_.push_back(int(i));
        total_ = int(pending_.size());
    }

    /// Takes from the pending steps those that are done.
    void keep_done()
    {
        for (const int i : std::vector<int>(pending_.begin(), pending_.end())) {
            stop_if_interrupted();
            const BatchStep& step = plan_.steps[std::size_t(i)];
            if (step.frame >= 0 && results_[std::size_t(step.frame)].fate != StepFate::kept)
                continue;
            try {
                const StepRecord record = read_record(folder_.record(step));
                if (is_done(folder_, step, record, inputs_.hash(step, frame_hash(step))))
                    finish(i, StepFate::kept, record);
            } catch (const InputError&) { // said when its turn comes
            }
        }
    }

    void run(const Progress& progress)
    {
        struct sigaction wake = {};
        wake.sa_handler = [](int) {};
        sigaction(SIGCHLD, &wake, nullptr);
        keep_done();
        tidy_up();
        sort_longest_first(pending_, plan_, folder_);
        auto next_look = Clock::now(), next_refresh = Clock::now() + refresh_after;
        while (!pending_.empty() || !running_.empty()) {
            if (!progress(total_ - int(pending_.size() + running_.size()), total_))
                stop_all();
            for (auto it = running_.begin(); it != running_.end();) {
                const auto next = std::next(it);
                if (const auto end = it->child.ended()) {
                    it->end = *end;
                    it->ended = Clock::now();
                    ended_.splice(ended_.end(), running_, it);
                }
                it = next;
            }
            const bool ended = !ended_.empty();
            if (ended || Clock::now() >= next_look) {
                start_some(); // while what has ended is hashed and published, the cores work
                conclude_ended();
                start_some();
                next_look = Clock::now() + again_after;
            }
            if (Clock::now() >= next_refresh) {
                for (const Running& one : running_)
                    one.lock.refresh();
                batch_lock.refresh();
                next_refresh = Clock::now() + refresh_after;
            }
            if (!ended)
                poll(nullptr, 0, poll_milliseconds); // a child's end interrupts it
        }
        if (total_ > 0)
            progress(total_, total_);
    }

    std::vector<StepResult> results() const { return results_; }

    LockFile batch_lock; ///< of the whole folder, where it is taken

private:
    struct Running {
        int step;
        ChildProcess child;
        LockFile lock;
        StepRecord record;
        Clock::time_point begun;
        double memory; ///< expected
        ChildEnd end;  ///< once it has ended, and when
        Clock::time_point ended;
    };

    std::string frame_hash(const BatchStep& step) const
    {
        return step.frame < 0 ? "" : outputs_.at(step.frame);
    }

    std::string frame_of(const BatchStep& step) const
    {
        return step.frame < 0 ? "" : folder_.output(plan_.steps[std::size_t(step.frame)]);
    }

    void finish(int i, StepFate fate, const StepRecord& record)
    {
        by_inputs_.emplace(record.inputs, i);
        results_[std::size_t(i)].fate = fate;
        outputs_[i] = record.output;
        pending_.remove(i);
    }

    /// Takes away what killed batches have left: of steps that are done, and of files that they
    /// were writing.
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

    static bool exists(const std::string& path) { return access(path.c_str(), F_OK) == 0; }

    void fail(int i, const std::string& reason)
    {
        const BatchStep& step = plan_.steps[std::size_t(i)];
        results_[std::size_t(i)] = {StepFate::failed, reason};
        pending_.remove(i);
        const bool log = exists(folder_.log(step));
        say(i, reason + (log ? "; see " + folder_.log(step) : ""));
        for (const int other : std::vector<int>(pending_.begin(), pending_.end()))
            if (plan_.steps[std::size_t(other)].frame == i) {
                results_[std::size_t(other)] = {StepFate::blocked, "its frame failed"};
                pending_.remove(other);
            }
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
        integral::say("batch", plan_.steps[std::size_t(i)].name + ": " + what);
    }

    void say_remark(int i, const StepRecord& record) const
    {
        if (!record.remark.empty())
            say(i, record.remark);
    }

    void start_some()
    {
        for (const int i : std::vector<int>(pending_.begin(), pending_.end())) {
            if (int(running_.size()) >= options_.at_once)
                return;
            const BatchStep& step = plan_.steps[std::size_t(i)];
            if (results_[std::size_t(i)].fate != StepFate::waiting ||
                (step.frame >= 0 && !outputs_.count(step.frame)))
                continue;
            stop_if_interrupted_here();
            try {
                start(i);
            } catch (const InputError& error) {
                fail(i, error.what());
            } catch (const OutputError& error) {
                fail(i, error.what());
            }
        }
    }

    void start(int i)
    {
        const BatchStep& step = plan_.steps[std::size_t(i)];
        const std::string frame = frame_of(step);
        const std::string hash = inputs_.hash(step, frame_hash(step));
        StepRecord record = read_record(folder_.record(step));
        if (is_done(folder_, step, record, hash))
            return finish(i, StepFate::kept, record);
        const auto twin = by_inputs_.find(hash);
        if (twin != by_inputs_.end() && twin->second != i &&
            results_[std::size_t(twin->second)].fate == StepFate::waiting)
            return; // it is running
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

        std::error_code ignored;
        std::filesystem::remove_all(folder_.work(step), ignored);
        std::filesystem::create_directories(folder_.work(step), ignored);
        record.inputs = hash;
        record.pixels = pixels;
        record.error.reset();
        record.remark.clear();
        if (copies)
            return copy(i, twin->second, record);
        by_inputs_[hash] = i;
        record.state = StepState::running;
        ++record.starts;
        record.output.clear();
        write_record(folder_.record(step), record);
        const std::string log = folder_.work(step) + "/said.txt";
        ChildProcess child(
            command_line(folder_, step, frame, threads_beside(others_beside(i), options_.at_once)),
            step.folder, log);
        pending_.remove(i);
        running_.push_back(
            {i, std::move(child), std::move(lock), record, Clock::now(), memory, {}, {}});
    }

    void copy(int i, int twin, StepRecord record)
    {
        const BatchStep& step = plan_.steps[std::size_t(i)];
        publish_copy(folder_, step, plan_.steps[std::size_t(twin)], record);
        clean(step);
        say_remark(i, record);
        finish(i, StepFate::copied, read_record(folder_.record(step)));
    }

    /// How many other steps could begin as well.
    int others_beside(int i) const
    {
        int others = 0;
        for (const int other : pending_)
            others += other != i && (plan_.steps[std::size_t(other)].frame < 0 ||
                                     outputs_.count(plan_.steps[std::size_t(other)].frame));
        return others;
    }

    bool has_memory(int i, double needed)
    {
        std::vector<MemoryUse> running;
        for (const Running& one : running_)
            running.push_back({one.memory, one.child.memory_now()});
        const std::string lack = memory_.lack(needed, running);
        if (lack.empty())
            return true;
        if (running_.empty())
            fail(i, lack + "; --memory MB gives it more");
        else
            say_once(i, lack + ": it waits");
        return false;
    }

    void conclude_ended()
    {
        while (!ended_.empty()) {
            conclude(ended_.front());
            ended_.pop_front();
        }
    }

    void conclude(Running& one)
    {
        const BatchStep& step = plan_.steps[std::size_t(one.step)];
        const std::string log = folder_.work(step) + "/said.txt";
        StepRecord& record = one.record;
        record.seconds = std::chrono::duration<double>(one.ended - one.begun).count();
        const std::string reason = publish_made(folder_, step, frame_of(step), log, one.end,
                                                record);
        std::error_code ignored;
        if (reason.empty()) {
            memory_.learn(step, frame_of(step), record);
            std::filesystem::remove(folder_.log(step), ignored);
            clean(step);
            say_remark(one.step, record);
            return finish(one.step, StepFate::made, read_record(folder_.record(step)));
        }
        if (interrupted()) // that is why: nothing to keep
            return clean(step);
        std::filesystem::copy_file(log, folder_.log(step),
                                   std::filesystem::copy_options::overwrite_existing, ignored);
        if (ignored) // half a log says less than none
            std::filesystem::remove(folder_.log(step), ignored);
        clean(step);
        record.state = StepState::failed;
        record.reason = reason;
        try {
            write_record(folder_.record(step), record);
        } catch (const OutputError&) { // the reason has been said, and the old record tells that it
                                       // is not done
        }
        if (++tries_[std::size_t(one.step)] <= options_.retries && !interrupted()) {
            say(one.step, reason + "; it is tried again");
            pending_.push_front(one.step);
            return;
        }
        fail(one.step, reason);
    }

    void clean(const BatchStep& step)
    {
        std::error_code ignored;
        std::filesystem::remove_all(folder_.work(step), ignored);
    }

    void stop_if_interrupted_here()
    {
        if (interrupted())
            stop_all();
    }

    [[noreturn]] void stop_all()
    {
        conclude_ended();
        for (Running& one : running_)
            one.child.stop();
        for (const auto until = Clock::now() + patience; !running_.empty() && Clock::now() < until;
             poll(nullptr, 0, poll_milliseconds))
            for (auto it = running_.begin(); it != running_.end();)
                if (it->child.ended()) {
                    clean(plan_.steps[std::size_t(it->step)]);
                    it = running_.erase(it);
                } else
                    ++it;
        running_.clear(); // which kills what is left
        throw Interrupted();
    }

    const BatchPlan& plan_;
    StepInputs& inputs_;
    const RunOptions& options_;
    const BatchFolder& folder_;
    std::vector<StepResult> results_;
    std::vector<int> tries_;
    std::vector<std::string> said_;
    std::list<int> pending_;
    std::list<Running> running_, ended_;   ///< ended: but not concluded
    std::map<int, std::string> outputs_;   ///< hashes of finished steps' outputs
    std::map<std::string, int> by_inputs_; ///< the step that makes, or has made, what comes of
                                           ///< these inputs
    MemoryForecast memory_;
    int total_ = 0;
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

std::vector<StepResult> survey(const Manifest& manifest, const BatchPlan& plan, StepInputs& inputs,
                               const RunOptions& options)
{
    const BatchFolder folder = batch_folder(manifest.output);
    Run run(manifest, plan, inputs, options, folder);
    run.keep_done();
    return run.results();
}

std::vector<StepResult> run_batch(const Manifest& manifest, const BatchPlan& plan,
                                  StepInputs& inputs, const RunOptions& options,
                                  const Progress& progress)
{
    const BatchFolder folder = make_batch_folder(manifest.output, plan);
    Run run(manifest, plan, inputs, options, folder);
    std::string holder;
    if (options.jobs.empty() && !run.batch_lock.take(folder.lock("batch"), holder))
        throw OutputError(
            manifest.output + ": another batch, " + holder +
            ", works in this folder; wait for it, or give this manifest another \"output\"");
    run.run(progress);
    return run.results();
}

} // namespace integral
