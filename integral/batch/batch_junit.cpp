// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/batch_junit.h"

#include "integral/base/file_bytes.h"
#include "integral/base/json.h"
#include "integral/base/message_text.h"
#include "integral/batch/renderer_options.h"
#include "integral/io/junit_xml.h"

#include <cstdlib>
#include <set>

namespace integral {
namespace {

/// The names of the jobs that are reported without seconds.
std::set<std::string> repeatable_jobs(const PlannedBatch& batch)
{
    const bool all = std::getenv("SOURCE_DATE_EPOCH") != nullptr;
    std::set<std::string> names;
    for (std::size_t job = 0; job < batch.manifest.jobs.size(); ++job) {
        const std::string value = value_of_option(batch.frame_of(int(job)).words,
                                                  "integral_metadata", "");
        if (all || in_small_letters(value) == "repeatable")
            names.insert(batch.manifest.jobs[job].name);
    }
    return names;
}

/// The last lines of a step's log; empty if it has none.
std::string end_of_log(const std::string& path)
{
    constexpr std::size_t most_bytes = 4000;
    try {
        const std::string text = read_file(path);
        if (text.size() <= most_bytes)
            return text;
        const auto line = text.find('\n', text.size() - most_bytes);
        return line == std::string::npos ? text.substr(text.size() - most_bytes)
                                         : "...\n" + text.substr(line + 1);
    } catch (const InputError&) {
        return "";
    }
}

JUnitCase case_of(const Json& step, const std::string& job, const std::string& folder,
                  bool repeatable)
{
    const std::string kind = step.at("kind"), state = step.at("state");
    JUnitCase one;
    one.group = job;
    one.name = kind;
    std::string log = folder + "/logs/" + kind + "." + job;
    if (step.at("target").is_string()) {
        one.name += " " + step.at("target").get<std::string>();
        log += "." + step.at("target").get<std::string>();
    }
    if (state == "failed") {
        one.outcome = JUnitOutcome::failure;
        one.type = kind;
        one.messages = {step.at("reason").is_string() ? step.at("reason").get<std::string>()
                                                      : "it failed"};
        if (!repeatable)
            one.output = end_of_log(log + ".txt");
    } else if (state != "done") {
        one.outcome = JUnitOutcome::skipped;
        one.messages = {state == "missing" ? "not yet made" : "its frame failed"};
    }
    if (!repeatable && step.at("seconds").is_number())
        one.seconds = step.at("seconds").get<double>();
    return one;
}

} // namespace

std::string batch_junit(const PlannedBatch& batch, const Json& summary)
{
    const std::set<std::string> repeatable = repeatable_jobs(batch);
    std::vector<JUnitCase> cases;
    for (const Json& job : summary.at("jobs")) {
        const std::string name = job.at("name");
        for (const Json& step : job.at("steps"))
            cases.push_back(case_of(step, name, batch.folder.path, repeatable.count(name) > 0));
    }
    return junit_xml(batch.manifest.path, cases);
}

} // namespace integral
