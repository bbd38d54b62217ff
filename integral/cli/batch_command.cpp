// SPDX-License-Identifier: AGPL-3.0-or-later
// integral batch: many frames, and what is made of them.
#include "integral/base/file_bytes.h"
#include "integral/base/number_text.h"
#include "integral/batch/batch_report.h"
#include "integral/batch/batch_run.h"
#include "integral/batch/batch_steps.h"
#include "integral/cli/batch_check.h"
#include "integral/cli/batch_slurm.h"
#include "integral/cli/command.h"
#include "integral/cli/progress.h"
#include "integral/cli/values.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <thread>

namespace integral {
namespace {

options::options_description make_options()
{
    options::options_description all("Options");
    all.add_options()("only", options::value<std::vector<std::string>>()->value_name("JOB"),
                      "only this job; may be given again. Several such runs may work in one folder "
                      "at once, also on several machines; they write no summary")(
        "jobs", options::value<int>()->value_name("N"),
        "programs that run at the same time, 1 to 4096 (default: one per core)")(
        "memory", options::value<std::string>()->value_name("MB"),
        "memory that they may take together (default: what the machine has free)")(
        "retry", options::value<int>()->value_name("N")->default_value(0),
        "how often a step that failed is tried again, 0 to 100 (default 0)")(
        "dry-run", options::bool_switch(),
        "only say what would be done")("summary", options::bool_switch(),
                                       "only write summary.json and index.html, of what is there")(
        "json", options::bool_switch(),
        "print the summary, or the plan of --dry-run, as JSON")("help", "print this");
    add_slurm_options(all);
    return all;
}

std::set<int> chosen_jobs(const options::variables_map& arguments, const Manifest& manifest)
{
    std::set<int> chosen;
    if (!given(arguments, "only"))
        return chosen;
    for (const std::string& name : arguments["only"].as<std::vector<std::string>>()) {
        const auto job = std::find_if(manifest.jobs.begin(), manifest.jobs.end(),
                                      [&](const BatchJob& one) { return one.name == name; });
        if (job == manifest.jobs.end())
            throw UsageError("--only " + name + ": there is no such job; --dry-run lists them");
        chosen.insert(int(job - manifest.jobs.begin()));
    }
    return chosen;
}

RunOptions run_options(const options::variables_map& arguments, const Manifest& manifest)
{
    RunOptions run;
    run.at_once = given(arguments, "jobs") ? in_range(arguments, "jobs", 1, 4096)
                                           : std::max(1, int(std::thread::hardware_concurrency()));
    run.retries = in_range(arguments, "retry", 0, 100);
    if (given(arguments, "memory")) {
        run.memory = parse_number("memory", text_of(arguments, "memory"), "a number of MB") *
                     (1 << 20);
        if (!(run.memory > 0))
            throw UsageError("--memory " + text_of(arguments, "memory") +
                             ": more than 0 MB is expected");
    }
    run.output_pixels = [&manifest](const BatchStep& step, Vec2 pixel_pitch) {
        return output_pixels(manifest, step, pixel_pitch);
    };
    run.jobs = chosen_jobs(arguments, manifest);
    return run;
}

/// The plan in words, a line for each step.
std::string plan_text(const nlohmann::ordered_json& summary)
{
    std::string text;
    int to_do = 0, kept = 0;
    for (const auto& job : summary.at("jobs"))
        for (const auto& step : job.at("steps")) {
            const bool is_kept = step.at("state") == "done";
            (is_kept ? kept : to_do) += 1;
            text += std::string(is_kept ? "kept   " : "to do  ") +
                    job.at("name").get<std::string>() + ": " + step.at("file").get<std::string>() +
                    "\n";
        }
    return text + counted(int(summary.at("jobs").size()), "job") + ": " + counted(to_do, "step") +
           " to do, " + std::to_string(kept) + " kept\n";
}

/// Writes summary.json and index.html.
void write_summary(const BatchFolder& folder, const nlohmann::ordered_json& summary)
{
    write_file(folder.path + "/summary.json", summary.dump(2) + "\n");
    write_file(folder.path + "/index.html", batch_page(summary, folder));
}

/// Says on standard error which jobs a cluster has not made. Returns whether there are any.
bool say_what_is_left(const nlohmann::ordered_json& summary)
{
    bool any = false;
    for (const auto& job : summary.at("jobs")) {
        const std::string state = job.at("state");
        if (state == "done")
            continue;
        any = true;
        const std::string lost = "its task ended without having made it, as if it was cancelled, "
                                 "killed or out of time; --slurm submits it again";
        say("batch", job.at("name").get<std::string>() + ": " +
                         (state == "failed" ? job.at("reason").get<std::string>() : lost));
    }
    return any;
}

int run(const options::variables_map& arguments)
{
    const bool dry = arguments["dry-run"].as<bool>(), json = arguments["json"].as<bool>();
    bool only_summary = arguments["summary"].as<bool>();
    if (dry && only_summary)
        throw UsageError("--dry-run and --summary do not go together");
    if (only_summary && given(arguments, "only"))
        throw UsageError("--summary is of all jobs: not with --only");
    const Manifest manifest = read_manifest(inputs_of(arguments)[0]);
    check_targets(manifest);
    RunOptions wanted = run_options(arguments, manifest);
    const BatchPlan plan = plan_of(manifest);
    const BatchPrograms programs = batch_programs();
    StepInputs inputs(manifest, programs);
    const PlannedBatch planned{manifest, plan, inputs, programs, wanted};
    std::set<int> merged;
    if (const auto made = do_task(arguments, planned, merged)) {
        if (!*made || merged.empty())
            return *made ? exit_done : exit_check_failed;
        wanted.jobs = merged;
    }
    const AfterSlurm after = use_slurm(arguments, planned);
    if (after == AfterSlurm::nothing)
        return exit_done;
    only_summary = only_summary || after == AfterSlurm::summary;
    const BatchFolder folder = batch_folder(manifest.output);
    const auto results = dry || only_summary
                             ? survey(manifest, plan, inputs, wanted)
                             : run_batch(manifest, plan, inputs, wanted, progress_bar("batch"));
    const auto summary = batch_summary(manifest, plan, results, wanted.jobs);
    if (!dry && wanted.jobs.empty())
        write_summary(folder, summary);
    const int failed = summary.at("jobs_failed").get<int>();
    if (json)
        print_result(arguments, summary.dump(2) + "\n");
    else if (dry)
        print_result(arguments, plan_text(summary));
    else
        print_result(arguments,
                     counted(summary.at("jobs_done").get<int>(), "job") + " done, " +
                         std::to_string(failed) + " failed" +
                         (only_summary
                              ? ", " + std::to_string(summary.at("jobs_missing").get<int>()) +
                                    " not yet made"
                              : "") +
                         "; " + counted(summary.at("steps_made").get<int>(), "step") + " made, " +
                         std::to_string(summary.at("steps_kept").get<int>()) + " kept\n");
    if (after == AfterSlurm::summary)
        return say_what_is_left(summary) ? exit_check_failed : exit_done;
    return !dry && failed > 0 ? exit_check_failed : exit_done;
}

} // namespace

const Command batch_command = {
    "batch",
    "a manifest of scenes, sheets, papers and panels: frames, prints, panel images, previews",
    "MANIFEST.json [--only JOB] [--jobs N] [--retry N] [--dry-run] [--slurm [--strips N]] "
    "[--follow] [--cancel]",
    "Renders every scene of a manifest behind every sheet, and makes of each frame its prints, "
    "panel\n"
    "images and previews, on all cores. What is there already, of the same inputs, is kept: a "
    "batch\n"
    "that was interrupted or killed goes on where it was, and after a change only what depends on "
    "it\n"
    "is made again. A failed step does not stop the others; its program's words are kept in "
    "logs/.\n"
    "The output folder gets summary.json and index.html. The user's guide explains the manifest.\n",
    1,
    1,
    make_options,
    run_from_map<run>};

} // namespace integral
