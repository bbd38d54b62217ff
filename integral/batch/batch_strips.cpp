// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/batch_strips.h"

#include "integral/base/json.h"
#include "integral/base/message_text.h"
#include "integral/batch/batch_steps.h"
#include "integral/batch/lock_file.h"
#include "integral/batch/renderer.h"
#include "integral/batch/renderer_options.h"
#include "integral/batch/scene_files.h"
#include "integral/io/image_file.h"
#include "integral/lightfield/first_samples.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace integral {
namespace {

constexpr int usual_block_side = 32; // the renderer's

std::string job_of(const BatchStep& frame) { return frame.name.substr(frame.name.find('.') + 1); }

std::string plan_file(const BatchFolder& folder, const BatchStep& frame)
{
    return folder.own() + "/strips/" + job_of(frame) + ".json";
}

/// Runs the renderer in a step's folder; what it says. Throws InputError with its reason.
std::string render_there(const BatchStep& step, Names words, const ScratchFolder& scratch)
{
    words.insert(words.begin(), renderer_program());
    const std::string log = scratch.path("said.txt");
    const ChildEnd end = ChildProcess(words, step.folder, log).wait();
    if (end.status != 0)
        throw InputError(step.name + ": " + failure_of(step, log, end));
    return read_file(log);
}

/// Whether the renderer says of a setting that it is on.
bool is_on(const std::string& said, const std::string& setting)
{
    const auto place = said.find(setting + "...");
    return place != std::string::npos &&
           said.compare(said.find_first_not_of('.', place + setting.size()), 2, "On") == 0;
}

/// Says once, while the work is planned, what makes two renderings of one scene differ.
void warn_of_chance(const BatchStep& frame, const BatchPrograms& programs, const std::string& said)
{
    std::vector<std::string> files;
    const std::string scene = renderer_options_in(frame.words[0]).at(0).value; // "FILE.ini" or
                                                                               // +I"FILE.pov"
    for (const SceneFile& file :
         files_of_scene(scene, {frame.folder, frame.words, programs.renderer_share}))
        if (file.path.rfind(programs.renderer_share, 0) != 0)
            files.push_back(file.path);
    std::string words;
    for (const std::string& word : words_of_chance(files))
        words += (words.empty() ? "" : ", ") + word;
    if (is_on(said, "Dithering"))
        words += (words.empty() ? "" : ", ") + std::string("dithering");
    if (!words.empty())
        say("batch", frame.name + ": it has " + words +
                         ": its strips cannot be promised to join without a seam, nor to equal the "
                         "frame rendered whole");
}

Json json_of(const StripPlan& plan)
{
    Json strips = Json::array();
    for (const RowStrip& strip : plan.strips)
        strips.push_back({strip.first, strip.rows, strip.above, strip.below});
    return {{"inputs", plan.inputs}, {"height", plan.height}, {"strips", std::move(strips)}};
}

/// Runs the renderer for two rows, and plans by what it says.
StripPlan asked_plan(const BatchStep& frame, const std::string& inputs, int number,
                     const BatchPrograms& programs)
{
    if (!value_of_option(frame.words, "integral_error_image", "").empty())
        throw InputError(frame.name +
                         ": Integral_Error_Image= is of whole frames; leave it out, or --strips");
    if (!value_of_option(frame.words, "integral_rows", "").empty())
        throw InputError(frame.name +
                         ": Integral_Rows= is the strips' own; leave it out, or --strips");
    const ScratchFolder scratch;
    const std::string picture = scratch.path("rows.png");
    Names words = frame.words;
    words.insert(words.end(), {"+FN", "Integral_Audit=off", "Integral_Depth_Image=", "End_Row=2",
                               "+O" + quoted(picture)});
    const std::string said = render_there(frame, words, scratch);
    const Frame rows = read_frame_with_metadata(picture);
    const std::string given = value_of_option(frame.words, "render_block_size", "bs");
    const int side = given.empty()
                         ? usual_block_side
                         : std::max(4, std::atoi(given.c_str())); // the renderer takes no less
    const int reach = is_on(said, "Antialiasing")
                          ? rows_looked_at(rows.metadata->sheet, rows.metadata->film)
                          : 0;
    warn_of_chance(frame, programs, said);
    return {inputs, rows.image.height, row_strips(rows.image.height, number, side, reach)};
}

} // namespace

BatchPlan strip_steps(const BatchStep& frame, const StripPlan& plan)
{
    BatchPlan steps;
    const std::string of = "of" + std::to_string(plan.strips.size()),
                      extension = frame.output.substr(frame.output.rfind('.'));
    const bool depth = !value_of_option(frame.words, "integral_depth_image", "").empty();
    for (std::size_t k = 0; k < plan.strips.size(); ++k) {
        BatchStep step = frame;
        const std::string name = job_of(frame) + "." + std::to_string(k + 1) + of;
        step.name = "strip." + name;
        step.output = ".integral-batch/strips/" + name + extension;
        step.rows = plan.strips[k];
        for (const std::string& option : options_of(plan.strips[k], plan.height))
            step.words.push_back(option);
        if (depth && k > 0) // a depth frame is of all rows
            step.words.push_back("Integral_Depth_Image=");
        steps.steps.push_back(step);
    }
    return steps;
}

std::optional<StripPlan> read_strip_plan(const BatchFolder& folder, const BatchStep& frame,
                                         const std::string& inputs)
{
    StripPlan plan;
    try {
        const Json json = parse_json(read_file(plan_file(folder, frame)));
        plan.inputs = json.at("inputs");
        plan.height = json.at("height");
        for (const Json& strip : json.at("strips"))
            plan.strips.push_back({strip.at(0), strip.at(1), strip.at(2), strip.at(3)});
    } catch (const InputError&) {
        return std::nullopt;
    } catch (const JsonError&) {
        return std::nullopt;
    } catch (const Json::exception&) {
        return std::nullopt;
    }
    return plan.inputs == inputs ? std::optional(plan) : std::nullopt;
}

StripPlan plan_strips(const BatchFolder& folder, const BatchStep& frame, const std::string& inputs,
                      int number, const BatchPrograms& programs)
{
    const auto known = read_strip_plan(folder, frame, inputs);
    if (known && (int(known->strips.size()) == number || known->strips.size() < 2))
        return *known;
    const StripPlan plan = asked_plan(frame, inputs, number, programs);
    write_file(plan_file(folder, frame), json_of(plan).dump() + "\n");
    return plan;
}

std::string merge_frame(const BatchFolder& folder, const BatchStep& frame, StepInputs& inputs)
{
    const std::string hash = inputs.hash(frame, "");
    StepRecord record = read_record(folder.record(frame));
    if (is_done(folder, frame, record, hash))
        return "";
    LockFile lock;
    std::string holder, reason;
    if (!lock.take(folder.lock(frame.name), holder))
        return holder + " makes it already";
    const auto plan = read_strip_plan(folder, frame, hash);
    record.inputs = hash;
    record.host = host_name();
    record.finished = time_now();
    ++record.starts;
    std::vector<BatchStep> steps;
    if (plan)
        steps = strip_steps(frame, *plan).steps;
    else
        reason = "it has no strips, or its scene has changed since they were made; submit it again";
    Names files;
    double seconds = 0;
    for (const BatchStep& step : steps) {
        const StepRecord strip = read_record(folder.record(step));
        if (reason.empty() && !is_done(folder, step, strip, inputs.hash(step, "")))
            reason = step.name + ": " +
                     (strip.reason.empty() ? "this strip is missing; submit the batch again"
                                           : strip.reason);
        files.push_back(folder.output(step));
        seconds += strip.seconds;
        record.memory = std::max(record.memory, strip.memory);
    }
    try {
        if (reason.empty()) {
            std::filesystem::create_directories(folder.work(frame));
            merge_strips(files, folder.made(frame));
            read_figures(folder.made(frame), record);
            record.seconds = seconds;
            publish(folder, frame, record);
            std::error_code ignored;
            for (const BatchStep& step : steps) {
                std::filesystem::remove(folder.output(step), ignored);
                std::filesystem::remove(folder.record(step), ignored);
            }
            std::filesystem::remove(plan_file(folder, frame), ignored);
        }
    } catch (const InputError& error) {
        reason = error.what();
    }
    std::error_code ignored;
    std::filesystem::remove_all(folder.work(frame), ignored);
    if (!reason.empty()) {
        record.state = StepState::failed;
        record.reason = reason;
        write_record(folder.record(frame), record);
    }
    return reason;
}

} // namespace integral
