// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/studio/studio_renders.h"

#include "integral/base/json.h"
#include "integral/batch/scene_look.h"
#include "integral/io/image_file.h"
#include "integral/io/markup.h"
#include "integral/replay/draft_frame.h"
#include "integral/studio/background_work.h"
#include "integral/studio/file_stamp.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

constexpr int first_width = 160, middle_width = 320;                // of a probe's view, pixels
constexpr auto time_between_looks = std::chrono::milliseconds(500); // at the input's files
constexpr auto time_without_listeners = std::chrono::seconds(10);   // ends the work

/// Whether two shapes, width / height, differ visibly.
bool are_different(double aspect, double other) { return std::fabs(aspect / other - 1) > 0.01; }

ProbeRequest first_probe(double aspect)
{
    ProbeRequest request;
    request.width = first_width;
    request.aspect = aspect;
    return request;
}

} // namespace

struct StudioRenders::Job {
    ScratchFolder scratch;
    std::optional<ProbeRequest> probe; ///< what it makes: this, or else `exact`
    std::optional<PrintRequest> print; ///< or this
    ExactRequest exact;
    int draft = 1;
    Clock::time_point began = Clock::now();
    std::optional<ChildProcess> child; ///< what makes it: this, or else `work`
    std::optional<BackgroundWork> work;

    std::string log() const { return scratch.path("said.txt"); }
    std::string picture() const { return scratch.path("picture.png"); }
};

StudioRenders::StudioRenders(StudioInput& input, std::optional<double> aspect)
    : input_(input), next_probe_(first_probe(aspect.value_or(input.aspect())))
{
}

StudioRenders::~StudioRenders() = default;

std::shared_ptr<const Probe> StudioRenders::probe() const
{
    const std::lock_guard lock(mutex_);
    return probe_;
}

std::shared_ptr<const ExactDraft> StudioRenders::exact() const
{
    const std::lock_guard lock(mutex_);
    return exact_;
}

/// Call it with mutex_ locked.
void StudioRenders::change()
{
    ++changes_;
    changed_.notify_all();
}

/// Whether live pictures need the requested probe before an exact draft is rendered. Call it with
/// mutex_ locked.
bool StudioRenders::is_urgent(const ProbeRequest& request) const
{
    return !probe_ || probe_->width < middle_width ||
           are_different(probe_->request.aspect, request.aspect);
}

void StudioRenders::request_exact(int number, const PlacementSettings& settings)
{
    const std::lock_guard lock(mutex_);
    next_exact_ = ExactRequest{number, settings};
    requested_exact_ = number;
    if (probe_ && !problem_.empty()) { // of an earlier exact draft
        problem_.clear();
        change();
    }
}

void StudioRenders::stop_exact(int number)
{
    const std::lock_guard lock(mutex_);
    if (requested_exact_ != number)
        return;
    next_exact_.reset();
    requested_exact_ = 0;
}

void StudioRenders::request_print(const PlacementSettings& settings, const std::string& file)
{
    const std::lock_guard lock(mutex_);
    next_print_ = PrintRequest{file, settings};
    print_is_stopped_ = false;
    print_.clear();
    if (probe_)
        problem_.clear();
    change();
}

void StudioRenders::stop_print()
{
    const std::lock_guard lock(mutex_);
    next_print_.reset();
    print_is_stopped_ = true;
    change();
}

std::string StudioRenders::print() const
{
    const std::lock_guard lock(mutex_);
    return print_;
}

std::string StudioRenders::state() const
{
    const std::lock_guard lock(mutex_);
    return Json{{"probe", probe_number_},
                {"exact", exact_ ? exact_->number : 0},
                {"draft", exact_ ? exact_->draft : 0},
                {"seconds", exact_ ? exact_->seconds : 0},
                {"printing", next_print_ || work_ == "print"},
                {"print", print_.empty() ? Json() : Json(print_)},
                {"print_word", for_shell(print_)},
                {"work", work_.empty() ? Json() : Json(work_)},
                {"progress", progress_},
                {"problem", problem_.empty() ? Json() : Json(problem_)}}
        .dump(-1, ' ', false, Json::error_handler_t::replace);
}

StudioRenders::Listener::Listener(StudioRenders& renders) : renders_(renders)
{
    const std::lock_guard lock(renders_.mutex_);
    ++renders_.listeners_;
}

StudioRenders::Listener::~Listener()
{
    const std::lock_guard lock(renders_.mutex_);
    --renders_.listeners_;
    renders_.left_ = Clock::now();
}

std::optional<std::string> StudioRenders::Listener::next_state()
{
    {
        std::unique_lock lock(renders_.mutex_);
        renders_.changed_.wait_for(lock, std::chrono::seconds(2), [&] {
            return renders_.ended_ || renders_.changes_ != sent_changes_;
        });
        if (renders_.ended_)
            return std::nullopt;
        if (renders_.changes_ == sent_changes_)
            return "";
        sent_changes_ = renders_.changes_;
    }
    return renders_.state();
}

void StudioRenders::end()
{
    job_.reset();
    const std::lock_guard lock(mutex_);
    ended_ = true;
    changed_.notify_all();
}

void StudioRenders::work()
{
    if (!is_watching_ || Clock::now() - watched_ > time_between_looks)
        watch_files();
    if (job_ && is_abandoned())
        job_.reset();
    if (job_)
        watch_job();
    if (job_)
        return;
    std::optional<ProbeRequest> probe;
    std::optional<ExactRequest> exact;
    std::optional<PrintRequest> print;
    {
        const std::lock_guard lock(mutex_);
        if (!work_.empty()) {
            work_.clear();
            change();
        }
        if (!problem_.empty() || listeners_ == 0)
            return;
        if (next_print_ && probe_)
            print.swap(next_print_);
        else if (next_probe_ && (is_urgent(*next_probe_) || !next_exact_))
            probe.swap(next_probe_);
        else
            exact.swap(next_exact_);
    }
    try {
        if (print)
            begin_print(*print);
        else if (probe)
            begin_probe(*probe);
        else if (exact)
            begin_exact(*exact);
    } catch (const std::exception& error) {
        const std::lock_guard lock(mutex_);
        problem_ = error.what();
        change();
    }
}

/// Returns whether the job's picture is no longer requested. A probe or print is requested again if
/// it is only put off, because no page listens or an exact draft is more urgent.
bool StudioRenders::is_abandoned()
{
    const std::lock_guard lock(mutex_);
    const bool unheard = listeners_ == 0 && Clock::now() - left_ > time_without_listeners;
    if (job_->print) {
        if (unheard && !print_is_stopped_ && !next_print_)
            next_print_ = job_->print;
        return unheard || print_is_stopped_;
    }
    if (!job_->probe)
        return unheard || job_->exact.number != requested_exact_;
    const bool is_put_off = unheard || (next_exact_ && !is_urgent(*job_->probe));
    if (is_put_off && !next_probe_)
        next_probe_ = job_->probe;
    return is_put_off;
}

/// Begins anew if one of the input's files has changed.
void StudioRenders::watch_files()
{
    watched_ = Clock::now();
    if (is_watching_ &&
        std::all_of(files_.begin(), files_.end(),
                    [](const auto& file) { return file_stamp(file.first) == file.second; }) &&
        !files_.empty())
        return;
    decltype(files_) files;
    try {
        for (const std::string& file : input_.files())
            files.emplace_back(file, file_stamp(file));
    } catch (const std::exception&) {
        files.clear(); // a scene is not here, but where povray-integral finds it; or is missing
    }
    const bool is_first = !is_watching_;
    is_watching_ = true;
    if (files == files_)
        return;
    files_ = files;
    if (is_first || files.empty())
        return;
    const std::optional<PrintRequest> print = job_ ? job_->print : std::nullopt;
    job_.reset(); // waits for its end, without the lock
    input_.forget();
    const std::lock_guard lock(mutex_);
    if (print && !next_print_)
        next_print_ = print;
    next_probe_ = first_probe(probe_        ? probe_->request.aspect
                              : next_probe_ ? next_probe_->aspect
                                            : 4.0 / 3);
    probe_.reset();
    exact_.reset();
    next_exact_.reset();
    problem_.clear();
    change();
}

void StudioRenders::begin_probe(const ProbeRequest& request)
{
    auto job = std::make_unique<Job>();
    job->probe = request;
    const Making making = input_.probe(request, job->scratch);
    begin(std::move(job), making);
}

void StudioRenders::begin_exact(const ExactRequest& request)
{
    const std::shared_ptr<const Probe> current = probe();
    if (!current)
        return;
    const FrameMetadata frame = frame_of_settings(request.settings, &current->depths);
    {
        const ProbeRequest required = probe_for(frame, current->sheet_distance);
        const std::lock_guard lock(mutex_);
        if (are_different(current->request.aspect, required.aspect)) {
            // The live picture has nothing to show in places that no probe contains.
            next_probe_ = first_probe(required.aspect);
            if (!next_exact_ && requested_exact_ == request.number)
                next_exact_ = request;
            return;
        }
        if (!serves(current->request, required))
            next_probe_ = required;
    }
    auto job = std::make_unique<Job>();
    job->exact = request;
    job->draft = draft_of_four_views(frame);
    const Making making = input_.print(request.settings, frame, job->draft, job->picture());
    begin(std::move(job), making);
}

void StudioRenders::begin_print(const PrintRequest& request)
{
    auto job = std::make_unique<Job>();
    job->print = request;
    const FrameMetadata frame = frame_of_settings(request.settings, &probe()->depths);
    const Making making = input_.print(request.settings, frame, std::nullopt, job->picture());
    begin(std::move(job), making);
}

void StudioRenders::begin(std::unique_ptr<Job> job, const Making& making)
{
    if (making.command.empty())
        job->work.emplace(making.function);
    else
        job->child.emplace(making.command, ".", job->log());
    job_ = std::move(job);
    const std::lock_guard lock(mutex_);
    work_ = job_->print ? "print" : job_->probe ? "probe" : "exact";
    progress_ = 0;
    change();
}

void StudioRenders::watch_job()
{
    std::string problem;
    try {
        if (!has_ended(*job_)) {
            const double part = job_->child ? rendered_part(job_->log()) : job_->work->part();
            const std::lock_guard lock(mutex_);
            if (std::fabs(part - progress_) >= 0.01) {
                progress_ = part;
                change();
            }
            return;
        }
        finish(*job_);
    } catch (const std::exception& error) {
        problem = error.what();
    }
    job_.reset();
    if (!problem.empty()) {
        const std::lock_guard lock(mutex_);
        problem_ = problem;
        change();
    }
}

/// Whether a job's work has ended. Throws if it failed.
bool StudioRenders::has_ended(Job& job)
{
    if (job.work)
        return job.work->ended();
    const auto end = job.child->ended();
    if (end && end->status == program_cannot_be_run)
        throw no_renderer(read_file(job.log()));
    if (end && end->status != 0)
        throw std::runtime_error(reason_in(read_file(job.log())));
    return end.has_value();
}

/// Publishes the job's picture.
void StudioRenders::finish(const Job& job)
{
    if (job.probe) {
        auto probe = std::make_shared<Probe>(input_.made_probe(*job.probe, job.scratch));
        const std::lock_guard lock(mutex_);
        // The fit must not change with the probe's number of views or pixels.
        if (probe_ && !are_different(probe_->request.aspect, job.probe->aspect))
            probe->depths.eye_distances = probe_->depths.eye_distances;
        probe_ = std::move(probe);
        ++probe_number_;
        if (probe_->width < middle_width) {
            next_probe_ = job.probe;
            next_probe_->width = middle_width;
        }
        change();
        return;
    }
    if (job.print) {
        write_file(job.print->file, read_file(job.picture()));
        const std::lock_guard lock(mutex_);
        print_ = job.print->file;
        change();
        return;
    }
    Frame frame = read_frame_with_metadata(job.picture());
    if (is_draft(frame))
        frame = *with_final_pixels(frame);
    frame.image = converted(frame.image, 8, Encoding{}, false);
    const double seconds = std::chrono::duration<double>(Clock::now() - job.began).count();
    auto exact = std::make_shared<const ExactDraft>(
        ExactDraft{job.exact.number, job.draft, seconds, std::move(frame)});
    const std::lock_guard lock(mutex_);
    exact_ = std::move(exact);
    change();
}

} // namespace integral
