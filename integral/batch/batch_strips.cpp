// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/batch_strips.h"

#include "integral/base/folders.h"
#include "integral/base/json.h"
#include "integral/base/message_text.h"
#include "integral/base/number_text.h"
#include "integral/batch/batch_steps.h"
#include "integral/batch/lock_file.h"
#include "integral/batch/renderer.h"
#include "integral/batch/renderer_options.h"
#include "integral/batch/scene_files.h"
#include "integral/io/image_file.h"
#include "integral/reconstruction/pass_rows.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace integral {
namespace {

std::string job_of(const BatchStep& frame) { return frame.name.substr(frame.name.find('.') + 1); }

std::string plan_file(const BatchFolder& folder, const BatchStep& frame)
{
    return folder.own() + "/strips/" + job_of(frame) + ".json";
}

/// Runs the renderer in a step's folder and returns its output. Throws InputError with the
/// renderer's reason.
std::string render_in_folder(const BatchStep& step, Names words, const ScratchFolder& scratch)
{
    words.insert(words.begin(), renderer_program());
    const std::string log = scratch.path("said.txt");
    const ChildEnd end = ChildProcess(words, step.folder, log).wait();
    if (end.status != 0)
        throw InputError(step.name + ": " + failure_of(step, log, end));
    return read_file(log);
}

/// Whether the renderer's output lists a setting as on.
bool is_on(const std::string& said, const std::string& setting)
{
    const auto place = said.find(setting + "...");
    return place != std::string::npos &&
           said.compare(said.find_first_not_of('.', place + setting.size()), 2, "On") == 0;
}

/// Warns on standard error of scene words and renderer settings that make two renderings differ.
/// `said` is the renderer's output.
void warn_of_randomness(const BatchStep& frame, const BatchPrograms& programs,
                        const std::string& said)
{
    std::vector<std::string> files;
    // The first word is "FILE.ini" or +I"FILE.pov".
    const std::string scene = renderer_options_in(frame.words[0]).at(0).value;
    for (const SceneFile& file :
         files_of_scene(scene, {frame.folder, frame.words, programs.renderer_share}))
        if (file.path.rfind(programs.renderer_share, 0) != 0)
            files.push_back(file.path);
    std::vector<std::string> causes = words_of_randomness(files);
    if (is_on(said, "Dithering"))
        causes.push_back("dithering");
    std::string list;
    for (const std::string& cause : causes)
        list += (list.empty() ? "" : ", ") + cause;
    if (!list.empty())
        say("batch", frame.name + ": it has " + list +
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

/// Renders two rows of the frame and plans the strips from their picture and the settings that the
/// renderer prints.
StripPlan new_plan(const BatchStep& frame, const std::string& inputs, int number,
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
    const std::string said = render_in_folder(frame, words, scratch);
    const Frame rows = read_frame_with_metadata(picture);
    const std::string given = value_of_option(frame.words, "render_block_size", "bs");
    const int side = given.empty() ? usual_block_side : block_side_of(std::atoi(given.c_str()));
    const int reach = is_on(said, "Antialiasing")
                          ? PassRows(rows.metadata->sheet, rows.metadata->film, side, true)
                                .sampled_from()
                          : 0;
    warn_of_randomness(frame, programs, said);
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
        if (depth && k > 0) // the first strip writes the depth frame for all rows
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

StripPlan plan_strips(PlannedBatch& batch, int job, int number)
{
    const BatchStep& frame = batch.frame_of(job);
    const std::string inputs = batch.inputs.hash(frame, "");
    const auto known = read_strip_plan(batch.folder, frame, inputs);
    if (known && (int(known->strips.size()) == number || known->strips.size() < 2))
        return *known;
    const StripPlan plan = new_plan(frame, inputs, number, batch.programs);
    write_file(plan_file(batch.folder, frame), json_of(plan).dump() + "\n");
    return plan;
}

bool render_strip(PlannedBatch& batch, int job, std::size_t number, RunOptions options,
                  const BatchReporter& reporter)
{
    const BatchStep& frame = batch.frame_of(job);
    const std::string inputs = batch.inputs.hash(frame, "");
    if (is_done(batch.folder, frame, read_record(batch.folder.record(frame)), inputs))
        return true;
    const auto plan = read_strip_plan(batch.folder, frame, inputs);
    if (!plan || number < 1 || number > plan->strips.size())
        throw InputError(frame.name + ": " +
                         (plan ? "it has " + counted(int(plan->strips.size()), "strip")
                               : "it is not cut in strips, or its scene has changed since; --slurm "
                                 "--strips N does it"));
    BatchPlan one;
    one.steps = {strip_steps(frame, *plan).steps[number - 1]};
    options.jobs = {job};
    return run_steps(batch, one, options, reporter)[0].fate != StepFate::failed;
}

namespace {

/// The strips from which a frame is joined.
struct StripsOfFrame {
    std::vector<BatchStep> steps;
    Names files;        ///< paths of the strips
    double seconds = 0; ///< sum over the strips
    double memory = 0;  ///< bytes, largest of the strips
    std::string reason; ///< why the strips make no frame; empty if they do
};

/// `hash`: hash of the frame's inputs.
StripsOfFrame strips_of(PlannedBatch& batch, const BatchStep& frame, const std::string& hash)
{
    StripsOfFrame all;
    const auto plan = read_strip_plan(batch.folder, frame, hash);
    if (!plan) {
        all.reason = "it has no strips, or its scene has changed since they were made; submit it "
                     "again";
        return all;
    }
    all.steps = strip_steps(frame, *plan).steps;
    for (const BatchStep& step : all.steps) {
        const StepRecord strip = read_record(batch.folder.record(step));
        if (all.reason.empty() && !is_done(batch.folder, step, strip, batch.inputs.hash(step, "")))
            all.reason = step.name + ": " +
                         (strip.reason.empty() ? "this strip is missing; submit the batch again"
                                               : strip.reason);
        all.files.push_back(batch.folder.output(step));
        all.seconds += strip.seconds;
        all.memory = std::max(all.memory, strip.memory);
    }
    return all;
}

/// Joins the strips to the frame, publishes it and deletes them. Throws InputError, OutputError.
void publish_merged(const BatchFolder& folder, const BatchStep& frame, const StripsOfFrame& strips,
                    StepRecord& record)
{
    make_folder(folder.work(frame));
    merge_strips(strips.files, folder.made(frame));
    read_figures(folder.made(frame), record);
    record.seconds = strips.seconds;
    publish(folder, frame, record);
    std::error_code ignored;
    for (const BatchStep& step : strips.steps) {
        std::filesystem::remove(folder.output(step), ignored);
        std::filesystem::remove(folder.record(step), ignored);
    }
    std::filesystem::remove(plan_file(folder, frame), ignored);
}

} // namespace

std::string merge_frame(PlannedBatch& batch, int job)
{
    make_batch_folder(batch.manifest.output, batch.plan);
    const BatchFolder& folder = batch.folder;
    const BatchStep& frame = batch.frame_of(job);
    const std::string hash = batch.inputs.hash(frame, "");
    StepRecord record = read_record(folder.record(frame));
    if (is_done(folder, frame, record, hash))
        return "";
    LockFile lock;
    std::string holder;
    if (!lock.take(folder.lock(frame.name), holder))
        return holder + " makes it already";
    StripsOfFrame strips = strips_of(batch, frame, hash);
    record.inputs = hash;
    record.host = host_name();
    record.finished = time_now();
    record.memory = std::max(record.memory, strips.memory);
    ++record.starts;
    try {
        if (strips.reason.empty())
            publish_merged(folder, frame, strips, record);
    } catch (const InputError& error) {
        strips.reason = error.what();
    }
    std::error_code ignored;
    std::filesystem::remove_all(folder.work(frame), ignored);
    if (!strips.reason.empty()) {
        record.state = StepState::failed;
        record.reason = strips.reason;
        write_record(folder.record(frame), record);
    }
    return strips.reason;
}

} // namespace integral
