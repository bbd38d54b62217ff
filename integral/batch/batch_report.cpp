// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/batch_report.h"

#include "integral/base/file_bytes.h"
#include "integral/base/number_text.h"
#include "integral/io/html_page.h"
#include "integral/io/markup.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace integral {
namespace {

using Json = nlohmann::ordered_json;

/// done, failed, blocked or missing.
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
article { background: var(--panel); border: 1px solid var(--line); border-radius: 6px; padding: 8px; overflow-wrap: anywhere; }
article.failed { border-color: var(--bad); }
.picture { height: 240px; display: flex; align-items: center; justify-content: center; color: var(--quiet); }
.picture img { max-width: 100%; max-height: 240px; }
article h2 { font-size: 1em; margin: .6em 0 .2em; }
article p { margin: .2em 0; }
article a { margin-right: .6em; display: inline-block; }
.reason { color: var(--bad); }
)css";

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
        const StepRecord record = read_record(folder.record(step));
        const std::string state = state_of(results[i], record);
        const std::string reason = state == "done" || state == "missing" ? ""
                                   : !results[i].reason.empty()          ? results[i].reason
                                                                         : record.reason;
        made += results[i].fate == StepFate::made;
        kept += results[i].fate == StepFate::kept;
        if (step.kind == StepKind::frame) {
            const BatchJob& job = manifest.jobs[std::size_t(step.job)];
            jobs.push_back(
                {{"name", job.name},
                 {"scene", manifest.scenes[std::size_t(job.scene)].name},
                 {"sheet", job.sheet < 0 ? Json(nullptr)
                                         : Json(manifest.sheets[std::size_t(job.sheet)].name)},
                 {"state", "done"},
                 {"reason", nullptr},
                 {"render_seconds", state == "done" ? Json(record.render_seconds) : Json(nullptr)},
                 {"error_rms",
                  state == "done" && record.error ? Json(*record.error) : Json(nullptr)},
                 {"seconds", 0},
                 {"steps", Json::array()}});
        }
        Json& job = jobs.back();
        if (state == "failed" || state == "missing")
            if (job["state"] != "failed")
                job["state"] = state;
        if (state == "failed" && job["reason"].is_null())
            job["reason"] = step.name + ": " + reason;
        if (state == "done")
            job["seconds"] = job["seconds"].get<double>() + record.seconds;
        job["steps"].push_back(
            {{"kind", name_of(step.kind)},
             {"target", step.kind == StepKind::frame ? Json(nullptr) : Json(step.target)},
             {"state", state},
             {"this_run", name_of(results[i].fate)},
             {"file", step.output},
             {"seconds", state == "done" ? Json(record.seconds) : Json(nullptr)},
             {"memory_bytes", state == "done" ? Json(std::llround(record.memory)) : Json(nullptr)},
             {"reason", reason.empty() ? Json(nullptr) : Json(reason)},
             {"remark",
              state == "done" && !record.remark.empty() ? Json(record.remark) : Json(nullptr)}});
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
    const auto count = [&](const char* field) {
        return std::to_string(summary.at(field).get<int>());
    };
    const std::string title = text_at(summary, "manifest");
    std::string page = "<h1>" + markup_text(title) + "</h1>\n<p>" +
                       counted(summary.at("jobs_done").get<int>(), "job") + " done, " +
                       count("jobs_failed") + " failed, " + count("jobs_missing") +
                       " not yet made</p>\n<div class=\"jobs\">\n";
    for (const Json& job : summary.at("jobs")) {
        const std::string name = markup_text(text_at(job, "name")), state = text_at(job, "state");
        std::string picture = state == "failed" ? "failed"
                              : state == "done" ? "no picture"
                                                : "not yet made",
                    links, remarks;
        for (const Json& step : job.at("steps")) {
            if (step.at("state") != "done")
                continue;
            const std::string file = text_at(step, "file"), kind = text_at(step, "kind");
            if (kind != "thumbnail") {
                if (step.at("remark").is_string())
                    remarks += "<p>" + kind + " " + markup_text(text_at(step, "target")) + ": " +
                               markup_text(text_at(step, "remark")) + "</p>\n";
                links += "<a href=\"" + link_to(file) + "\">" + kind +
                         (kind == "frame" ? "" : " " + markup_text(text_at(step, "target"))) +
                         "</a>\n";
                continue;
            }
            try {
                picture = "<img alt=\"" + name +
                          ", seen from the middle\" src=\"data:image/png;base64," +
                          base64(read_file(folder.path + "/" + file)) + "\">";
            } catch (const InputError&) { // it has gone since
            }
        }
        page += "<article class=\"" + state + "\"><div class=\"picture\">" + picture +
                "</div>\n<h2>" + name + "</h2>\n";
        if (job.at("render_seconds").is_number())
            page += "<p>" + figure(job.at("render_seconds"), 3) + " s, estimated error " +
                    figure(job.at("error_rms"), 3) + "</p>\n";
        page += "<p>" + links + "</p>\n" + remarks;
        if (job.at("reason").is_string())
            page += "<p class=\"reason\">" + markup_text(text_at(job, "reason")) + "</p>\n";
        page += "</article>\n";
    }
    return html_page(title, page_style, page + "</div>\n");
}

} // namespace integral
