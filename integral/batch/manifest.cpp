// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/manifest.h"

#include "integral/base/file_bytes.h"
#include "integral/base/message_text.h"
#include "integral/batch/manifest_fields.h"

#include <algorithm>
#include <filesystem>
#include <fnmatch.h>
#include <unordered_map>
#include <unordered_set>

namespace integral {
namespace {

/// Position of a list's things, by their names.
using NameIndex = std::unordered_map<std::string, int>;

/// -1 if there is no such name.
int index_of(const NameIndex& index, const std::string& name)
{
    const auto found = index.find(name);
    return found == index.end() ? -1 : found->second;
}

/// A manifest during reading.
struct Reading {
    Manifest manifest;
    NameIndex scenes, sheets, papers, panels, previews, jobs;
    std::size_t steps = 0; ///< of all jobs so far
};

/// Reads a list of named things.
template <class Thing, class Read>
void read_list(const SourceJson& root, const char* field, std::vector<Thing>& all, NameIndex& index,
               const Read& read)
{
    if (!root.has(field))
        return;
    for (const SourceJson& object : root.field(field).list()) {
        all.push_back(read(object));
        if (!index.emplace(all.back().name, int(all.size()) - 1).second)
            object.field("name").throw_input("there are two of the name " + all.back().name +
                                             " in " + field);
    }
}

template <class Thing> Names names_of(const std::vector<Thing>& things)
{
    Names names;
    for (const Thing& thing : things)
        names.push_back(thing.name);
    return names;
}

/// The indices of the things that a field selects by name; empty if there is no such field.
template <class Thing>
std::optional<Indices> chosen(const SourceJson& object, const char* field,
                              const std::vector<Thing>& things, const NameIndex& index)
{
    if (!object.has(field))
        return std::nullopt;
    Indices all;
    std::unordered_set<int> seen;
    for (const SourceJson& one : object.field(field).list()) {
        const std::string name = one.text();
        all.push_back(index_of(index, name));
        if (all.back() < 0)
            one.throw_input(excerpt(name) + " is not among the manifest's " + field + ": " +
                            list_of(names_of(things)));
        if (!seen.insert(all.back()).second)
            one.throw_input(name + " stands here twice");
    }
    return all;
}

Targets targets_in(const SourceJson& object, const Reading& reading)
{
    const Manifest& manifest = reading.manifest;
    return {chosen(object, "papers", manifest.papers, reading.papers),
            chosen(object, "panels", manifest.panels, reading.panels),
            chosen(object, "previews", manifest.previews, reading.previews)};
}

/// Reads a paper, panel or preview. `field`: the name of the field that defines it ("paper" or
/// "panel"; "" for a preview). `what`: the text for BatchTarget::what.
BatchTarget read_target(const SourceJson& object, const Names& formats, const char* field,
                        const std::string& what)
{
    const auto place_of = [&](const char* name) {
        return (object.has(name) ? object.field(name) : object).place();
    };
    return {name_in(object.field("name")),
            format_in(object, formats),
            what,
            command_options(object, field),
            place_of(field),
            place_of("options")};
}

BatchTarget read_paper(const SourceJson& object)
{
    object.allow({"name", "paper", "options", "format"});
    return read_target(object, {"pdf", "tiff", "png"}, "paper",
                       object.has("paper") ? object.field("paper").text() : "");
}

BatchTarget read_panel(const SourceJson& object, const Manifest& manifest)
{
    object.allow({"name", "panel", "options", "format"});
    const SourceJson panel = object.field("panel"); // a name that integral lcd knows, or a file
    const bool file = extension_of(panel.text()) == "json" ||
                      panel.text().find('/') != std::string::npos || panel.text().empty();
    return read_target(object, {"png", "tiff", "exr"}, "panel",
                       file ? readable_file(panel, manifest.folder) : panel.text());
}

BatchTarget read_preview(const SourceJson& object)
{
    object.allow({"name", "options", "format"});
    return read_target(object, {"png", "exr", "tiff", "webp", "html"}, "", "");
}

BatchScene read_scene(const SourceJson& object, const Reading& reading)
{
    object.allow({"name", "file", "options", "declare", "size", "inputs", "sheets", "papers",
                  "panels", "previews"});
    const std::string& folder = reading.manifest.folder;
    BatchScene scene;
    scene.name = name_in(object.field("name"));
    const SourceJson file = object.field("file");
    scene.file = readable_file(file, folder);
    const std::string extension = extension_of(scene.file);
    if (extension != "pov" && extension != "ini")
        file.throw_input("a scene, .pov or .ini, is expected");
    check_quotable(file, scene.file);
    check_renderer_name(file, scene.file.substr(scene.file.rfind('/') + 1));
    scene.options = renderer_options(object);
    scene.declare = declarations(object);
    scene.size = size_in(object);
    if (object.has("inputs"))
        for (const SourceJson& one : object.field("inputs").list())
            scene.inputs.push_back(readable_file(one, folder));
    scene.sheets = chosen(object, "sheets", reading.manifest.sheets, reading.sheets);
    scene.targets = targets_in(object, reading);
    return scene;
}

BatchSheet read_sheet(const SourceJson& object, const Reading& reading)
{
    object.allow({"name", "camera", "options", "size", "papers", "panels", "previews"});
    BatchSheet sheet;
    sheet.name = name_in(object.field("name"));
    const SourceJson camera = object.field("camera");
    sheet.camera = camera.text();
    if (sheet.camera.find_first_not_of(" \t\n") == std::string::npos)
        camera.throw_input(
            "the integral camera's words are expected, as in lens_sheet { ... } film { dpi 300 }");
    check_quotable(camera, sheet.camera);
    sheet.options = renderer_options(object);
    sheet.size = size_in(object);
    sheet.targets = targets_in(object, reading);
    return sheet;
}

/// The job's own choice of targets, else its sheet's, else its scene's, else all of `count`.
Indices picked(const std::optional<Indices>& own, const std::optional<Indices>& sheets,
               const std::optional<Indices>& scenes, std::size_t count)
{
    for (const std::optional<Indices>* choice : {&own, &sheets, &scenes})
        if (*choice)
            return **choice;
    Indices all;
    for (std::size_t i = 0; i < count; ++i)
        all.push_back(int(i));
    return all;
}

/// Completes a job's name and targets and adds the job; messages refer to `place`.
void add_job(Reading& reading, const SourceJson& place, BatchJob job, const Targets& own)
{
    Manifest& manifest = reading.manifest;
    const BatchScene& scene = manifest.scenes[std::size_t(job.scene)];
    const BatchSheet none, &sheet = job.sheet < 0 ? none : manifest.sheets[std::size_t(job.sheet)];
    if (job.name.empty())
        job.name = scene.name + (job.sheet < 0 ? "" : "-" + sheet.name);
    if (!reading.jobs.emplace(job.name, int(manifest.jobs.size())).second)
        place.throw_input("there are two jobs of the name " + job.name);
    if (manifest.jobs.size() == most_jobs)
        place.throw_input("there are more than " + std::to_string(most_jobs) +
                          " jobs; divide them among several manifests");
    const Targets &of_sheet = sheet.targets, &of_scene = scene.targets;
    job.papers = picked(own.papers, of_sheet.papers, of_scene.papers, manifest.papers.size());
    job.panels = picked(own.panels, of_sheet.panels, of_scene.panels, manifest.panels.size());
    job.previews = picked(own.previews, of_sheet.previews, of_scene.previews,
                          manifest.previews.size());
    reading.steps += 2 + job.papers.size() + job.panels.size() + job.previews.size();
    if (reading.steps > most_steps)
        place.throw_input(
            "the jobs up to " + job.name + " have more than " + std::to_string(most_steps) +
            " steps: each has its frame, a thumbnail and all its papers, panels and "
            "previews; choose fewer of these for a scene, a sheet or a job, or divide the "
            "jobs among several manifests");
    manifest.jobs.push_back(std::move(job));
}

/// Adds a job for every scene behind each of its sheets.
void make_jobs(const SourceJson& root, Reading& reading)
{
    const auto scenes = root.field("scenes").list();
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const Indices sheets = picked(reading.manifest.scenes[i].sheets, {}, {},
                                      reading.manifest.sheets.size());
        BatchJob job;
        job.scene = int(i);
        if (sheets.empty())
            add_job(reading, scenes[i], job, {});
        for (const int sheet : sheets) {
            job.sheet = sheet;
            add_job(reading, scenes[i], job, {});
        }
    }
}

/// Reads the jobs that the manifest lists itself.
void read_jobs(const SourceJson& list, Reading& reading)
{
    const Manifest& manifest = reading.manifest;
    for (const SourceJson& object : list.list()) {
        object.allow({"name", "scene", "sheet", "papers", "panels", "previews"});
        BatchJob job;
        if (object.has("name"))
            job.name = name_in(object.field("name"));
        job.scene = index_of(reading.scenes, object.field("scene").text());
        if (job.scene < 0)
            object.field("scene").throw_input("it is not among the manifest's scenes: " +
                                              list_of(names_of(manifest.scenes)));
        if (object.has("sheet")) {
            job.sheet = index_of(reading.sheets, object.field("sheet").text());
            if (job.sheet < 0)
                object.field("sheet").throw_input("it is not among the manifest's sheets: " +
                                                  list_of(names_of(manifest.sheets)));
        }
        add_job(reading, object, job, targets_in(object, reading));
    }
}

void exclude_jobs(const SourceJson& list, Manifest& manifest)
{
    for (const SourceJson& one : list.list()) {
        const std::string pattern = one.text();
        const auto fits = [&](const BatchJob& job) {
            return fnmatch(pattern.c_str(), job.name.c_str(), 0) == 0;
        };
        const auto kept = std::remove_if(manifest.jobs.begin(), manifest.jobs.end(), fits);
        if (kept == manifest.jobs.end())
            one.throw_input("no job is called " + excerpt(pattern) +
                            (manifest.jobs.empty()
                                 ? ""
                                 : "; there is, for one, " + manifest.jobs.front().name));
        manifest.jobs.erase(kept, manifest.jobs.end());
    }
}

void read_output(const SourceJson& field, Manifest& manifest)
{
    const std::string output = field.text();
    if (output.empty())
        field.throw_input("the name of a folder is expected");
    manifest.output = path_in(manifest.folder, output);
    check_renderer_name(field, std::filesystem::absolute(manifest.output));
}

void read_frames(const SourceJson& frames, Manifest& manifest)
{
    frames.allow({"format", "bits"});
    manifest.frame_format = format_in(frames, {"png", "exr"});
    if (!frames.has("bits"))
        return;
    const SourceJson bits = frames.field("bits");
    manifest.frame_bits = bits.whole(8, 16);
    if ((manifest.frame_bits != 8 && manifest.frame_bits != 16) || manifest.frame_format != "png")
        bits.throw_input("8 or 16 is expected, of PNG");
}

void read_targets(const SourceJson& root, Reading& reading)
{
    Manifest& manifest = reading.manifest;
    read_list(root, "papers", manifest.papers, reading.papers, read_paper);
    read_list(root, "panels", manifest.panels, reading.panels,
              [&](const SourceJson& object) { return read_panel(object, manifest); });
    read_list(root, "previews", manifest.previews, reading.previews, read_preview);
}

} // namespace

std::string path_in(const std::string& folder, const std::string& name)
{
    return name.empty() || name[0] == '/' || folder.empty() ? name : folder + "/" + name;
}

Manifest read_manifest(const std::string& path)
{
    const SourceJson root = SourceJson::parse(display_name(path, "standard input"),
                                              read_file(path));
    root.allow({"output", "frames", "scenes", "sheets", "papers", "panels", "previews", "jobs",
                "exclude"});
    Reading reading;
    Manifest& manifest = reading.manifest;
    manifest.path = path;
    const auto slash = path.rfind('/');
    manifest.folder = slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
    read_output(root.field("output"), manifest);
    if (root.has("frames"))
        read_frames(root.field("frames"), manifest);
    read_targets(root, reading);
    read_list(root, "sheets", manifest.sheets, reading.sheets,
              [&](const SourceJson& object) { return read_sheet(object, reading); });
    read_list(root, "scenes", manifest.scenes, reading.scenes,
              [&](const SourceJson& object) { return read_scene(object, reading); });
    if (root.has("jobs"))
        read_jobs(root.field("jobs"), reading);
    else
        make_jobs(root, reading);
    if (root.has("exclude"))
        exclude_jobs(root.field("exclude"), manifest);
    if (manifest.jobs.empty())
        root.throw_input("there are no jobs");
    return std::move(reading.manifest);
}

} // namespace integral
