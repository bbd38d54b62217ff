// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/plan.h"

#include "integral/base/file_bytes.h"
#include "integral/batch/content_hash.h"
#include "integral/batch/renderer_options.h"
#include "integral/batch/scene_files.h"

#include <cstdlib>
#include <sys/stat.h>

namespace integral {
namespace {

constexpr char record_format[] = "1"; // a new value changes the hash of every step

std::string folder_of(const std::string& path)
{
    const auto slash = path.rfind('/');
    return slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
}

std::string last_part(const std::string& path) { return path.substr(path.rfind('/') + 1); }

BatchStep frame_step(const Manifest& manifest, const BatchJob& job)
{
    const BatchScene& scene = manifest.scenes[std::size_t(job.scene)];
    const std::string path = path_in(manifest.folder, scene.file), file = last_part(path);
    BatchStep step;
    step.name = "frame." + job.name;
    step.output = "frames/" + job.name + "." + manifest.frame_format;
    step.folder = folder_of(path);
    step.words.push_back((extension_of(file) == "ini" ? "" : "+I") + quoted(file));
    step.words.insert(step.words.end(), scene.options.begin(), scene.options.end());
    for (const auto& [name, value] : scene.declare)
        step.words.push_back("Declare=" + name + "=" + value);
    step.size = scene.size;
    if (job.sheet >= 0) {
        const BatchSheet& sheet = manifest.sheets[std::size_t(job.sheet)];
        step.words.insert(step.words.end(), sheet.options.begin(), sheet.options.end());
        step.words.push_back("Integral_Camera=" + sheet.camera);
        if (sheet.size.width > 0)
            step.size = sheet.size;
    }
    step.threads = std::atoi(value_of_option(step.words, "work_threads", "wt").c_str());
    if (step.size.width > 0) {
        step.words.push_back("+W" + std::to_string(step.size.width));
        step.words.push_back("+H" + std::to_string(step.size.height));
    }
    // A single picture, without window, pause or files of its own; with progress.
    for (const char* word : {"+KFI1", "+KFF1", "-D", "-P", "-C", "+V"})
        step.words.push_back(word);
    step.words.push_back(manifest.frame_format == "exr" ? "+FE" : "+FN");
    if (manifest.frame_bits > 0)
        step.words.push_back("Bits_Per_Color=" + std::to_string(manifest.frame_bits));
    for (const std::string& input : scene.inputs)
        step.files.push_back(path_in(manifest.folder, input));
    return step;
}

/// Adds the files named by options of a command, as in --icc FILE and --sheet=FILE.
void add_named_files(const Manifest& manifest, BatchStep& step, const Names& options)
{
    for (const std::string& word : options) {
        const auto equals = word.find('=');
        const std::string name = word[0] == '-'
                                     ? (equals == std::string::npos ? "" : word.substr(equals + 1))
                                     : word;
        struct stat status;
        const std::string path = path_in(manifest.folder, name);
        if (!name.empty() && stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode))
            step.files.push_back(path);
    }
}

/// The steps of one job, whose frame comes first.
class JobSteps {
public:
    JobSteps(const Manifest& manifest, int job, BatchPlan& plan)
        : manifest_(manifest), job_(job), plan_(plan), frame_(int(plan.steps.size()))
    {
        BatchStep frame = frame_step(manifest, manifest.jobs[std::size_t(job)]);
        frame.job = job;
        plan.steps.push_back(std::move(frame));
        plan.frames.push_back(frame_);
    }

    /// Adds the step that runs the command `words` on the frame; `index` is the target's in its
    /// list.
    void add(StepKind kind, const BatchTarget& target, int index, Names words)
    {
        const std::string name = manifest_.jobs[std::size_t(job_)].name + "." + target.name;
        BatchStep step;
        step.kind = kind;
        step.name = std::string(name_of(kind)) + "." + name;
        step.job = job_;
        step.frame = frame_;
        step.target = index;
        step.target_name = target.name;
        step.output = std::string(name_of(kind)) + "s/" + name + "." + target.format;
        step.folder = manifest_.folder;
        step.words = std::move(words);
        step.words.insert(step.words.end(), target.options.begin(), target.options.end());
        add_named_files(manifest_, step, step.words);
        plan_.steps.push_back(std::move(step));
    }

private:
    const Manifest& manifest_;
    int job_;
    BatchPlan& plan_;
    int frame_;
};

} // namespace

const char* const frame_word = "@frame";

const char* name_of(StepKind kind)
{
    switch (kind) {
    case StepKind::frame: return "frame";
    case StepKind::print: return "print";
    case StepKind::panel: return "panel";
    case StepKind::preview: return "preview";
    case StepKind::thumbnail: break;
    }
    return "thumbnail";
}

BatchPlan plan_of(const Manifest& manifest)
{
    BatchPlan plan;
    for (std::size_t j = 0; j < manifest.jobs.size(); ++j) {
        const BatchJob& job = manifest.jobs[j];
        JobSteps steps(manifest, int(j), plan);
        steps.add(StepKind::thumbnail, {"eye", "png", "", {}, "", ""}, -1, {"replay", frame_word});
        for (const int i : job.previews)
            steps.add(StepKind::preview, manifest.previews[std::size_t(i)], i,
                      {"replay", frame_word});
        for (const int i : job.papers) {
            const BatchTarget& paper = manifest.papers[std::size_t(i)];
            Names words{"print", frame_word};
            if (!paper.what.empty())
                words.insert(words.end(), {"--paper", paper.what});
            steps.add(StepKind::print, paper, i, words);
        }
        for (const int i : job.panels) {
            const BatchTarget& panel = manifest.panels[std::size_t(i)];
            steps.add(StepKind::panel, panel, i, {"lcd", frame_word, "--panel", panel.what});
        }
    }
    return plan;
}

StepInputs::StepInputs(const Manifest& manifest, BatchPrograms programs)
    : manifest_(manifest), programs_(std::move(programs))
{
}

const std::string& StepInputs::content(const std::string& path)
{
    const auto found = contents_.find(path);
    return found != contents_.end() ? found->second
                                    : contents_.emplace(path, hash_of_file(path)).first->second;
}

const std::string& StepInputs::scene_hash(const BatchStep& step)
{
    const BatchScene& scene = manifest_
                                  .scenes[std::size_t(manifest_.jobs[std::size_t(step.job)].scene)];
    std::string key = step.folder + "\n" + scene.file;
    for (const std::string& word : step.words)
        key += "\n" + word;
    const auto known = scenes_.find(key);
    if (known != scenes_.end())
        return known->second;
    ContentHash hash;
    for (const SceneFile& file : files_of_scene(
             last_part(scene.file), {step.folder, step.words, programs_.renderer_share})) {
        hash.add(file.name);
        hash.add(content(file.path));
    }
    return scenes_.emplace(key, hash.digits()).first->second;
}

std::string StepInputs::hash(const BatchStep& step, const std::string& frame_hash)
{
    const bool frame = step.kind == StepKind::frame;
    ContentHash hash;
    hash.add(record_format);
    hash.add(name_of(step.kind));
    hash.add(frame ? programs_.renderer_version : programs_.integral_version);
    hash.add(step.output.substr(step.output.rfind('.') + 1));
    hash.add(frame ? scene_hash(step) : frame_hash);
    hash.add(std::to_string(step.words.size()));
    for (const std::string& word : step.words)
        hash.add(word);
    for (const std::string& file : step.files)
        hash.add(content(file));
    return hash.digits();
}

} // namespace integral
