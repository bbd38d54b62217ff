// SPDX-License-Identifier: AGPL-3.0-or-later
// integral batch: many frames, and the pictures made from them.
#include "integral/base/file_bytes.h"
#include "integral/base/json.h"
#include "integral/base/number_text.h"
#include "integral/batch/batch_junit.h"
#include "integral/batch/batch_report.h"
#include "integral/batch/batch_run.h"
#include "integral/batch/batch_strips.h"
#include "integral/batch/cluster.h"
#include "integral/batch/terminal_progress.h"
#include "integral/cli/batch_check.h"
#include "integral/cli/command.h"
#include "integral/cli/progress.h"
#include "integral/cli/values.h"

#include <algorithm>
#include <iostream>
#include <thread>

namespace integral {
namespace {

constexpr int most_at_once = 4096; // of --jobs and of --cpus
constexpr int most_retries = 100;
constexpr int most_strips = 10000;

struct BatchOptions : CommonOptions {
    Arguments only;
    std::optional<int> jobs;
    std::optional<std::string> memory, junit;
    int retry = 0;
    bool dry_run = false, summary = false, json = false;

    // Cluster:
    bool slurm = false, follow = false, cancel = false;
    std::optional<int> strips, cpus;
    std::optional<std::string> partition, time;
    Arguments sbatch;

    // Commands of the tasks that --slurm submits:
    std::optional<std::string> strip, merge;
};

void declare_cluster(options::options_description& all, BatchOptions& o)
{
    add(all, "slurm", o.slurm,
        "submit what is not done, and not in the queue, to a Slurm cluster whose nodes share these "
        "folders; again: what is left");
    add(all, "follow", o.follow,
        "wait until the cluster has done it, then write the summary; an interrupt leaves the tasks "
        "in the queue");
    add(all, "cancel", o.cancel, "take the batch from the cluster's queue; what is done is kept");
    add(all, "strips", o.strips, "N",
        "with --slurm: render each frame in so many strips of rows, 1 to 10000, and join them");
    add(all, "cpus", o.cpus, "N (=1)", "with --slurm: cores of each task");
    add(all, "partition", o.partition, "NAME",
        "with --slurm: the cluster's partition. --memory is each task's");
    add(all, "time", o.time, "TIME",
        "with --slurm: the most that a task may take, minutes or DAYS-HOURS:MINUTES");
    add(all, "sbatch", o.sbatch, "OPTION",
        "with --slurm: one more option of sbatch's, as in --sbatch=--account=art; may be given "
        "again");
}

void declare(options::options_description& all, BatchOptions& o)
{
    add(all, "only", o.only, "JOB",
        "only this job; may be given again. Several such runs may work in one folder at once, also "
        "on several machines; they write no summary");
    add(all, "jobs", o.jobs, "N",
        "programs that run at the same time, 1 to 4096 (default: one per core)");
    add(all, "memory", o.memory, "MB",
        "memory that they may take together (default: what the machine has free)");
    all.add_options()("retry", fills(o.retry, "N")->default_value(o.retry),
                      "how often a step that failed is tried again, 0 to 100 (default 0)");
    add(all, "dry-run", o.dry_run, "only say what would be done");
    add(all, "summary", o.summary, "only write summary.json and index.html, of what is there");
    add(all, "json", o.json, "print the summary, or the plan of --dry-run, as JSON");
    add(all, "junit", o.junit, "FILE",
        "write the outcome of every step as JUnit XML, for CI systems");
    declare_cluster(all, o);
}

void declare_internal(options::options_description& all, BatchOptions& o)
{
    add(all, "strip", o.strip, "JOB:K", "render the K-th strip of a frame that --slurm has cut");
    add(all, "merge", o.merge, "JOB", "make the frame of its strips, then all that is made of it");
}

int job_called(const char* option, const std::string& name, const Manifest& manifest)
{
    const auto job = std::find_if(manifest.jobs.begin(), manifest.jobs.end(),
                                  [&](const BatchJob& one) { return one.name == name; });
    if (job == manifest.jobs.end())
        throw UsageError(std::string("--") + option + " " + name +
                         ": there is no such job; --dry-run lists them");
    return int(job - manifest.jobs.begin());
}

RunOptions run_options(const BatchOptions& o, const Manifest& manifest)
{
    RunOptions run;
    run.at_once = o.jobs ? in_range("jobs", *o.jobs, 1, most_at_once)
                         : std::max(1, int(std::thread::hardware_concurrency()));
    run.retries = in_range("retry", o.retry, 0, most_retries);
    if (o.memory) {
        run.memory = parse_number("memory", *o.memory, "a number of MB") * (1 << 20);
        if (!(run.memory > 0))
            throw_usage("memory", *o.memory, "more than 0 MB");
    }
    run.output_pixels = output_pixels;
    for (const std::string& name : o.only)
        run.jobs.insert(job_called("only", name, manifest));
    return run;
}

/// Rejects cluster options that exclude each other or need --slurm.
void check_cluster_options(const BatchOptions& o)
{
    if (o.cancel && (o.slurm || o.follow))
        throw UsageError("--cancel does not work with --slurm or --follow; leave them out");
    if (o.dry_run && (o.slurm || o.follow || o.cancel))
        throw UsageError("--dry-run does not work with --slurm, --follow and --cancel; it prints "
                         "what --slurm submits");
    if (o.slurm)
        return;
    if (o.cpus)
        throw UsageError("--cpus is for --slurm; --jobs says how many programs run here");
    throw_if_given({{"strips", o.strips},
                    {"partition", o.partition},
                    {"time", o.time},
                    {"sbatch", !o.sbatch.empty()}},
                   "is for --slurm");
}

ClusterOptions cluster_options(const BatchOptions& o)
{
    if (o.inputs[0] == "-")
        throw UsageError("a manifest from standard input cannot be submitted; put it into a file");
    ClusterOptions cluster;
    cluster.strips = in_range("strips", o.strips.value_or(1), 1, most_strips);
    cluster.cpus = in_range("cpus", o.cpus.value_or(1), 1, most_at_once);
    cluster.partition = o.partition.value_or("");
    cluster.time = o.time.value_or("");
    cluster.sbatch = o.sbatch;
    return cluster;
}

/// --slurm. Returns whether every job was submitted.
bool submit(PlannedBatch& batch, const RunOptions& requested, const ClusterOptions& cluster)
{
    const Submitted submitted = submit_batch(batch, requested, cluster);
    std::cout << counted(submitted.tasks, "task") << " submitted, " << submitted.queued_before
              << " in the queue before\n"
              << std::flush;
    return submitted.every_job;
}

/// --strip JOB:K
int make_strip(PlannedBatch& batch, const std::string& text, const RunOptions& requested)
{
    constexpr std::size_t most_digits = 6;
    const auto colon = text.rfind(':');
    const std::string number = colon == std::string::npos ? "" : text.substr(colon + 1);
    if (number.empty() || number.size() > most_digits ||
        number.find_first_not_of("0123456789") != std::string::npos)
        throw UsageError("--strip " + text + ": JOB:K is expected, K from 1 on");
    const int job = job_called("strip", text.substr(0, colon), batch.manifest);
    const bool made = render_strip(batch, job, std::stoul(number), requested, batch_reporter());
    return made ? exit_done : exit_check_failed;
}

/// --merge JOB: returns whether the frame is made, and prints the reason if not. Limits `requested`
/// to this job.
bool merge_job(PlannedBatch& batch, const std::string& name, RunOptions& requested)
{
    const int job = job_called("merge", name, batch.manifest);
    const std::string reason = merge_frame(batch, job);
    if (!reason.empty())
        say("batch", batch.frame_of(job).name + ": " + reason);
    requested.jobs = {job};
    return reason.empty();
}

/// Runs the batch, or only surveys its outputs, and reports.
int run_and_report(PlannedBatch& batch, const RunOptions& requested, const BatchOptions& o)
{
    const bool only_summary = o.summary || o.follow;
    const auto results = o.dry_run || only_summary ? survey(batch, requested)
                                                   : run_batch(batch, requested, batch_reporter());
    const auto summary = batch_summary(batch.manifest, batch.plan, results, requested.jobs);
    if (!o.dry_run && requested.jobs.empty())
        write_summary(batch.folder, summary);
    if (o.junit)
        write_file(*o.junit, batch_junit(batch, summary));
    print_result(std::nullopt, o.json      ? summary.dump(2) + "\n"
                               : o.dry_run ? plan_text(summary)
                                           : result_text(summary, only_summary));
    if (o.follow)
        return say_what_is_left(summary) ? exit_check_failed : exit_done;
    return !o.dry_run && summary.at("jobs_failed") > 0 ? exit_check_failed : exit_done;
}

int run(const BatchOptions& o)
{
    if (o.dry_run && o.summary)
        throw UsageError("--dry-run and --summary do not go together");
    if (o.summary && !o.only.empty())
        throw UsageError("--summary is of all jobs: not with --only");
    if (o.junit && (o.dry_run || o.cancel || o.strip || (o.slurm && !o.follow)))
        throw UsageError("--junit needs a run whose outcome is known: not with --dry-run, --cancel "
                         "or --slurm without --follow");
    if (o.junit)
        check_writable(*o.junit);
    Manifest manifest = read_manifest(o.inputs[0]);
    check_targets(manifest);
    RunOptions requested = run_options(o, manifest);
    check_cluster_options(o);
    const ClusterOptions cluster = o.slurm ? cluster_options(o) : ClusterOptions();

    PlannedBatch batch(std::move(manifest));
    if (o.merge && !merge_job(batch, *o.merge, requested))
        return exit_check_failed;
    if (o.strip && !o.merge)
        return make_strip(batch, *o.strip, requested);
    if (o.cancel) {
        std::cout << counted(cancel_batch(batch), "task") << " cancelled\n" << std::flush;
        return exit_done;
    }
    const bool all_submitted = !o.slurm || submit(batch, requested, cluster);
    if (o.follow)
        follow_batch(batch, progress_bar("cluster"));
    else if (!all_submitted)
        throw InputError("not every job could be submitted");
    else if (o.slurm)
        return exit_done;
    return run_and_report(batch, requested, o);
}

} // namespace

const Command batch_command = {
    "batch",
    "a manifest of scenes, sheets, papers and panels: frames, prints, panel images, previews",
    "MANIFEST.json [--only JOB] [--jobs N] [--retry N] [--dry-run] [--slurm [--strips N]] "
    "[--follow] [--cancel]",
    R"(Renders every scene of a manifest behind every sheet, and makes of each frame its prints, panel
images and previews, on all cores. What is there already, of the same inputs, is kept: a batch
that was interrupted or killed goes on where it was, and after a change only what depends on it
is made again. A failed step does not stop the others; its program's words are kept in logs/.
The output folder gets summary.json and index.html. doc/commands/batch.md explains the manifest.
)",
    1,
    1,
    described<BatchOptions>,
    run_with<BatchOptions, run>};

} // namespace integral
