// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/batch_report.h"

#include "integral/base/file_bytes.h"
#include "integral/base/json.h"
#include "integral/base/message_text.h"
#include "integral/base/number_text.h"
#include "integral/io/html_page.h"
#include "integral/io/markup.h"

#include <cmath>

namespace integral {
namespace {

/// The state of a step in the summary: done, failed, blocked or missing.
std::string state_of(const StepResult& result, const StepRecord& record)
{
    if (result.fate == StepFate::failed || result.fate == StepFate::blocked)
        return name_of(result.fate);
    if (result.fate == StepFate::waiting)
        return record.state == StepState::failed ? "failed" : "missing";
    return "done";
}

std::string text_at(const Json& object, const char* field)
{
    return object.at(field).is_string() ? object.at(field).get<std::string>() : "";
}

std::string figure(const Json& value, int digits)
{
    return value.is_number() ? with_digits(value.get<double>(), digits) : "–";
}

constexpr char page_style[] = R"css(
.jobs { display: grid; grid-template-columns: repeat(auto-fill, minmax(256px, 1fr)); gap: 1em; }
article { background: var(--panel); border: 1px solid var(--line); border-radius: 6px; padding: 8px;
  overflow-wrap: anywhere; }
article.failed { border-color: var(--bad); }
.picture { height: 240px; display: flex; align-items: center; justify-content: center; color: var(--quiet); }
.picture img { max-width: 100%; max-height: 240px; }
article h2 { font-size: 1em; margin: .6em 0 .2em; }
article p { margin: .2em 0; }
article a { margin-right: .6em; display: inline-block; }
.reason { color: var(--bad); }
)css";

/// A job's entry in the summary, without its steps.
Json job_entry(const Manifest& manifest, const BatchJob& job)
{
    return {{"name", job.name},
            {"scene", manifest.scenes[std::size_t(job.scene)].name},
            {"sheet",
             job.sheet < 0 ? Json(nullptr) : Json(manifest.sheets[std::size_t(job.sheet)].name)},
            {"state", "done"},
            {"reason", nullptr},
            {"render_seconds", nullptr},
            {"error_rms", nullptr},
            {"seconds", 0},
            {"steps", Json::array()}};
}

/// Adds a step to its job's entry.
void add_step(Json& job, const BatchStep& step, const StepResult& result, const StepRecord& record)
{
    const std::string state = state_of(result, record);
    const bool done = state == "done";
    const std::string reason = done || state == "missing" ? ""
                               : !result.reason.empty()   ? result.reason
                                                          : record.reason;
    if (step.kind == StepKind::frame && done) {
        if (record.render_seconds > 0)
            job["render_seconds"] = record.render_seconds;
        if (record.error)
            job["error_rms"] = *record.error;
    }
    if ((state == "failed" || state == "missing") && job["state"] != "failed")
        job["state"] = state;
    if (state == "failed" && job["reason"].is_null())
        job["reason"] = step.name + ": " + reason;
    if (done)
        job["seconds"] = job["seconds"].get<double>() + record.seconds;
    job["steps"].push_back(
        {{"kind", name_of(step.kind)},
         {"target", step.kind == StepKind::frame ? Json(nullptr) : Json(step.target_name)},
         {"state", state},
         {"this_run", name_of(result.fate)},
         {"file", step.output},
         {"seconds", done ? Json(record.seconds) : Json(nullptr)},
         {"memory_bytes", done ? Json(std::llround(record.memory)) : Json(nullptr)},
         {"reason", reason.empty() ? Json(nullptr) : Json(reason)},
         {"remark", done && !record.remark.empty() ? Json(record.remark) : Json(nullptr)}});
}

/// The thumbnail of a job as an element of a page; empty if its file is missing.
std::optional<std::string> thumbnail(const std::string& job, const std::string& path)
{
    try {
        return "<img alt=\"" + job + ", seen from the middle\" src=\"data:image/png;base64," +
               base64(read_file(path)) + "\">";
    } catch (const InputError&) {
        return std::nullopt;
    }
}

/// A moving preview as an element of a page. It replaces the thumbnail `still` unless the reader
/// prefers reduced motion.
std::string moving_picture(const std::string& job, const std::string& file,
                           const std::string& still)
{
    const auto source = still.find("data:");
    const std::string quiet = source == std::string::npos
                                  ? ""
                                  : "<source media=\"(prefers-reduced-motion: reduce)\" srcset=\"" +
                                        still.substr(source, still.find('"', source) - source) +
                                        "\">";
    return "<picture>" + quiet + "<img alt=\"" + job + ", moving\" src=\"" + link_to(file) +
           "\"></picture>";
}

/// A job's part of the page. `folder` holds the job's files.
std::string job_article(const Json& job, const BatchFolder& folder)
{
    const std::string name = markup_text(text_at(job, "name")), state = text_at(job, "state");
    std::string picture = state == "failed" ? "failed"
                          : state == "done" ? "no picture"
                                            : "not yet made",
                links, remarks, moving;
    for (const Json& step : job.at("steps")) {
        if (step.at("state") != "done")
            continue;
        const std::string file = text_at(step, "file"), kind = text_at(step, "kind");
        if (kind == "thumbnail") {
            picture = thumbnail(name, folder.path + "/" + file).value_or(picture);
            continue;
        }
        if (kind == "preview" && moving.empty() && extension_of(file) == "webp")
            moving = file;
        const std::string target = markup_text(text_at(step, "target"));
        if (step.at("remark").is_string())
            remarks += "<p>" + kind + " " + target + ": " + markup_text(text_at(step, "remark")) +
                       "</p>\n";
        links += "<a href=\"" + link_to(file) + "\">" + kind +
                 (kind == "frame" ? "" : " " + target) + "</a>\n";
    }
    if (!moving.empty())
        picture = moving_picture(name, moving, picture);
    std::string article = "<article class=\"" + state + "\"><div class=\"picture\">" + picture +
                          "</div>\n<h2>" + name + "</h2>\n";
    const bool has_seconds = job.at("render_seconds").is_number();
    if (has_seconds || job.at("error_rms").is_number())
        article += "<p>" + (has_seconds ? figure(job.at("render_seconds"), 3) + " s, " : "") +
                   "estimated error " + figure(job.at("error_rms"), 3) + "</p>\n";
    article += "<p>" + links + "</p>\n" + remarks;
    if (job.at("reason").is_string())
        article += "<p class=\"reason\">" + markup_text(text_at(job, "reason")) + "</p>\n";
    return article + "</article>\n";
}

int count(const Json& summary, const char* field) { return summary.at(field).get<int>(); }

} // namespace

Json batch_summary(const Manifest& manifest, const BatchPlan& plan,
                   const std::vector<StepResult>& results, const std::set<int>& only)
{
    const BatchFolder folder = batch_folder(manifest.output);
    Json jobs = Json::array();
    int done = 0, failed = 0, missing = 0, made = 0, kept = 0;
    for (std::size_t i = 0; i < plan.steps.size(); ++i) {
        const BatchStep& step = plan.steps[i];
        if (!only.empty() && !only.count(step.job))
            continue;
        if (step.kind == StepKind::frame)
            jobs.push_back(job_entry(manifest, manifest.jobs[std::size_t(step.job)]));
        add_step(jobs.back(), step, results[i], read_record(folder.record(step)));
        made += results[i].fate == StepFate::made;
        kept += results[i].fate == StepFate::kept;
    }
    for (const Json& job : jobs) {
        done += job["state"] == "done";
        failed += job["state"] == "failed";
        missing += job["state"] == "missing";
    }
    return {{"manifest", manifest.path}, {"jobs_done", done},  {"jobs_failed", failed},
            {"jobs_missing", missing},   {"steps_made", made}, {"steps_kept", kept},
            {"jobs", std::move(jobs)}};
}

std::string batch_page(const Json& summary, const BatchFolder& folder)
{
    const std::string title = text_at(summary, "manifest");
    std::string page = "<h1>" + markup_text(title) + "</h1>\n<p>" +
                       counted(count(summary, "jobs_done"), "job") + " done, " +
                       std::to_string(count(summary, "jobs_failed")) + " failed, " +
                       std::to_string(count(summary, "jobs_missing")) +
                       " not yet made</p>\n<div class=\"jobs\">\n";
    for (const Json& job : summary.at("jobs"))
        page += job_article(job, folder);
    return html_page(title, page_style, page + "</div>\n");
}

void write_summary(const BatchFolder& folder, const Json& summary)
{
    write_file(folder.path + "/summary.json", summary.dump(2) + "\n");
    write_file(folder.path + "/index.html", batch_page(summary, folder));
}

std::string plan_text(const Json& summary)
{
    std::string text;
    int to_do = 0, kept = 0;
    for (const Json& job : summary.at("jobs"))
        for (const Json& step : job.at("steps")) {
            const bool is_kept = step.at("state") == "done";
            (is_kept ? kept : to_do) += 1;
            text += std::string(is_kept ? "kept   " : "to do  ") +
                    job.at("name").get<std::string>() + ": " + step.at("file").get<std::string>() +
                    "\n";
        }
    return text + counted(int(summary.at("jobs").size()), "job") + ": " + counted(to_do, "step") +
           " to do, " + std::to_string(kept) + " kept\n";
}

std::string result_text(const Json& summary, bool with_missing)
{
    return counted(count(summary, "jobs_done"), "job") + " done, " +
           std::to_string(count(summary, "jobs_failed")) + " failed" +
           (with_missing ? ", " + std::to_string(count(summary, "jobs_missing")) + " not yet made"
                         : "") +
           "; " + counted(count(summary, "steps_made"), "step") + " made, " +
           std::to_string(count(summary, "steps_kept")) + " kept\n";
}

bool say_what_is_left(const Json& summary)
{
    bool any = false;
    for (const Json& job : summary.at("jobs")) {
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

} // namespace integral
