// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/batch_run.h"

#include "integral/batch/lock_file.h"
#include "integral/cli/batch_steps.h"
#include "integral/cli/command.h"
#include "integral/cli/progress.h"
#include "integral/io/file_bytes.h"
#include "integral/lightfield/number_text.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
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

std::string megabytes(double bytes) { return with_decimals(std::ceil(bytes / (1 << 20)), 0) + " MB"; }

class Run {
public:
    Run(const Manifest& manifest, const BatchPlan& plan, StepInputs& inputs, const RunOptions& options, const BatchFolder& folder)
        : manifest_(manifest), plan_(plan), inputs_(inputs), options_(options), folder_(folder), results_(plan.steps.size()),
          tries_(plan.steps.size()), said_(plan.steps.size())
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
        // The longest first: then the last ones to end do so at nearly the same time. What a frame's steps make of it comes at once.
        std::map<int, double> cost;
        for (const int i : pending_) {
            const BatchStep& step = plan_.steps[std::size_t(i)];
            const double seconds = read_record(folder_.record(step)).seconds;
            cost[i] = step.frame >= 0 ? 1e300 : seconds > 0 ? seconds : pixels_of(step, "") * 1e-6;
        }
        pending_.sort([&](int a, int b) { return cost[a] != cost[b] ? cost[a] > cost[b] : a < b; });
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
    enum class Start { begun, over, later };

    std::string frame_hash(const BatchStep& step) const { return step.frame < 0 ? "" : outputs_.at(step.frame); }

    std::string frame_of(const BatchStep& step) const { return step.frame < 0 ? "" : folder_.output(plan_.steps[std::size_t(step.frame)]); }

    void finish(int i, StepFate fate, const StepRecord& record)
    {
        by_inputs_.emplace(record.inputs, i);
        results_[std::size_t(i)].fate = fate;
        outputs_[i] = record.output;
        pending_.remove(i);
    }

    /// Takes away what killed batches have left: of steps that are done, and of files that they were writing.
    void tidy_up()
    {
        for (const char* const own : {"", "/.integral-batch/locks", "/.integral-batch/steps", "/.integral-batch/strips", "/.integral-batch/slurm"})
            sweep_unfinished(folder_.path + own);
        for (std::size_t i = 0; i < plan_.steps.size(); ++i) {
            const BatchStep& step = plan_.steps[i];
            LockFile lock;
            std::string holder;
            if (results_[i].fate == StepFate::kept && (exists(folder_.work(step)) || exists(folder_.lock(step.name))) && lock.take(folder_.lock(step.name), holder))
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
        const char* const line_start = isatty(2) ? "\r\033[K" : ""; // on a terminal a bar may stand in the line
        std::fprintf(stderr, "%sintegral batch: %s: %s\n", line_start, plan_.steps[std::size_t(i)].name.c_str(), what.c_str());
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
            if (results_[std::size_t(i)].fate != StepFate::waiting || (step.frame >= 0 && !outputs_.count(step.frame)))
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
        if (twin != by_inputs_.end() && twin->second != i && results_[std::size_t(twin->second)].fate == StepFate::waiting)
            return; // it is running
        const double pixels = pixels_of(step, frame), memory = expected_memory(step, pixels, record);
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
        ChildProcess child(command_line(folder_, step, frame, threads_for(i)), step.folder, log);
        pending_.remove(i);
        running_.push_back({i, std::move(child), std::move(lock), record, Clock::now(), memory, {}, {}});
    }

    void copy(int i, int twin, StepRecord record)
    {
        const BatchStep &step = plan_.steps[std::size_t(i)], &other = plan_.steps[std::size_t(twin)];
        const StepRecord theirs = read_record(folder_.record(other));
        std::error_code error;
        std::filesystem::copy_file(folder_.output(other), folder_.made(step), error);
        if (error)
            throw OutputError(folder_.made(step) + ": cannot be written: " + error.message());
        record.seconds = theirs.seconds;
        record.memory = theirs.memory;
        record.render_seconds = theirs.render_seconds;
        record.error = theirs.error;
        record.remark = theirs.remark;
        record.finished = time_now();
        record.host = host_name();
        publish(folder_, step, record);
        clean(step);
        say_remark(i, record);
        finish(i, StepFate::copied, read_record(folder_.record(step)));
    }

    /// One thread each while there is enough to do; the last frames have more, so that no core is idle while they end.
    int threads_for(int i) const
    {
        int others = 0; // that could start as well
        for (const int other : pending_)
            others += other != i && (plan_.steps[std::size_t(other)].frame < 0 || outputs_.count(plan_.steps[std::size_t(other)].frame));
        return others + 1 >= options_.at_once ? 1 : (options_.at_once + others) / (others + 1);
    }

    double expected_memory(const BatchStep& step, double pixels, const StepRecord& record) const
    {
        const auto known = memory_.find({step.kind, step.frame < 0 ? scene_of(step) : -1});
        if (known != memory_.end())
            return memory_for(step.kind, pixels, known->second.first, known->second.second);
        return memory_for(step.kind, pixels, record.memory, record.pixels);
    }

    int scene_of(const BatchStep& step) const { return manifest_.jobs[std::size_t(step.job)].scene; }

    bool has_memory(int i, double needed)
    {
        double available = options_.memory > 0 ? options_.memory : free_memory();
        for (const Running& one : running_)
            available -= options_.memory > 0 ? std::max(one.memory, one.child.memory_now()) : std::max(0.0, one.memory - one.child.memory_now());
        if (needed <= available)
            return true;
        const std::string figures = "it needs about " + megabytes(needed) + " of memory, and " + megabytes(std::max(0.0, available)) + " are left";
        if (running_.empty())
            fail(i, figures + "; --memory MB gives it more");
        else
            say_once(i, figures + ": it waits");
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
        const ChildEnd& end = one.end;
        const BatchStep& step = plan_.steps[std::size_t(one.step)];
        const std::string made = folder_.made(step), log = folder_.work(step) + "/said.txt";
        StepRecord& record = one.record;
        record.seconds = std::chrono::duration<double>(one.ended - one.begun).count();
        record.memory = end.memory;
        record.finished = time_now();
        record.host = host_name();
        std::string reason;
        try {
            if (end.signal != 0 || end.status != 0 || !is_whole(made))
                reason = failure_of(step, log, end);
            else {
                if (step.kind == StepKind::frame)
                    read_figures(made, record);
                else
                    record.remark = remark_of(step, log, frame_of(step));
                if (step.rows)
                    cut_strip(made, *step.rows, made);
                publish(folder_, step, record);
            }
        } catch (const InputError& error) {
            reason = error.what();
        } catch (const OutputError& error) {
            reason = error.what();
        }
        std::error_code ignored;
        if (reason.empty()) {
            auto& known = memory_[{step.kind, step.frame < 0 ? scene_of(step) : -1}];
            known = std::max(known, {record.memory, record.pixels});
            std::filesystem::remove(folder_.log(step), ignored);
            clean(step);
            say_remark(one.step, record);
            return finish(one.step, StepFate::made, read_record(folder_.record(step)));
        }
        if (interrupted()) // that is why: nothing to keep
            return clean(step);
        std::filesystem::copy_file(log, folder_.log(step), std::filesystem::copy_options::overwrite_existing, ignored);
        if (ignored) // half a log says less than none
            std::filesystem::remove(folder_.log(step), ignored);
        clean(step);
        record.state = StepState::failed;
        record.reason = reason;
        try {
            write_record(folder_.record(step), record);
        } catch (const OutputError&) { // the reason has been said, and the old record tells that it is not done
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
        for (const auto until = Clock::now() + patience; !running_.empty() && Clock::now() < until; poll(nullptr, 0, poll_milliseconds))
            for (auto it = running_.begin(); it != running_.end();)
                if (it->child.ended()) {
                    clean(plan_.steps[std::size_t(it->step)]);
                    it = running_.erase(it);
                } else
                    ++it;
        running_.clear(); // which kills what is left
        throw Interrupted();
    }

    const Manifest& manifest_;
    const BatchPlan& plan_;
    StepInputs& inputs_;
    const RunOptions& options_;
    const BatchFolder& folder_;
    std::vector<StepResult> results_;
    std::vector<int> tries_;
    std::vector<std::string> said_;
    std::list<int> pending_;
    std::list<Running> running_, ended_; ///< ended: but not concluded
    std::map<int, std::string> outputs_;       ///< hashes of finished steps' outputs
    std::map<std::string, int> by_inputs_;     ///< the step that makes, or has made, what comes of these inputs
    std::map<std::pair<StepKind, int>, std::pair<double, double>> memory_; ///< most bytes, and pixels, of a kind and scene
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

std::vector<StepResult> survey(const Manifest& manifest, const BatchPlan& plan, StepInputs& inputs, const RunOptions& options)
{
    const BatchFolder folder = batch_folder(manifest.output);
    Run run(manifest, plan, inputs, options, folder);
    run.keep_done();
    return run.results();
}

std::vector<StepResult> run_batch(const Manifest& manifest, const BatchPlan& plan, StepInputs& inputs, const RunOptions& options, const Progress& progress)
{
    const BatchFolder folder = make_batch_folder(manifest.output, plan);
    Run run(manifest, plan, inputs, options, folder);
    std::string holder;
    if (options.jobs.empty() && !run.batch_lock.take(folder.lock("batch"), holder))
        throw OutputError(manifest.output + ": another batch, " + holder + ", works in this folder; wait for it, or give this manifest another \"output\"");
    run.run(progress);
    return run.results();
}

} // namespace integral
