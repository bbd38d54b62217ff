// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/manifest.h"

#include "integral/base/file_bytes.h"
#include "integral/base/message_text.h"
#include "integral/batch/located_json.h"
#include "integral/batch/renderer_options.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fnmatch.h>
#include <set>
#include <sys/stat.h>
#include <unistd.h>

namespace integral {
namespace {

constexpr int largest_side = 1000000; // pixels
constexpr std::size_t most_jobs = 10000;
constexpr std::size_t most_listed = 20; // names in a message
constexpr char both_quotes[] = "both kinds of quotation marks in it cannot be passed on";

std::string list_of(const Names& names)
{
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), most_listed); ++i)
        text += (text.empty() ? "" : ", ") + names[i];
    return text.empty() ? "none" : text + (names.size() > most_listed ? ", ..." : "");
}

/// A name becomes part of files' names and of jobs'.
std::string name_in(const Located& field)
{
    const std::string name = field.text();
    const bool right = !name.empty() && name.size() <= 100 && name[0] != '-' &&
                       name.find_first_not_of(
                           "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") ==
                           std::string::npos;
    if (!right)
        field.refuse("a name of letters, digits, _ and - is expected, at most 100 of them");
    return name;
}

FrameSize size_in(const Located& object)
{
    if (!object.has("size"))
        return {};
    const Located field = object.field("size");
    const auto sides = field.list();
    if (sides.size() != 2)
        field.refuse("[WIDTH, HEIGHT] in pixels is expected");
    return {sides[0].whole(1, largest_side), sides[1].whole(1, largest_side)};
}

std::string readable_file(const Located& field, const std::string& folder)
{
    const std::string name = field.text(), path = path_in(folder, name);
    struct stat status;
    if (name.empty())
        field.refuse("the name of a file is expected");
    if (stat(path.c_str(), &status) != 0 ||
        (S_ISREG(status.st_mode) && access(path.c_str(), R_OK) != 0))
        field.refuse(excerpt(name) + " cannot be read: " + std::strerror(errno) +
                     "; names start at the manifest's folder");
    if (!S_ISREG(status.st_mode))
        field.refuse(excerpt(name) + " is no file");
    return name;
}

Names renderer_options(const Located& object)
{
    Names all;
    if (!object.has("options"))
        return all;
    for (const Located& one : object.field("options").list()) {
        all.push_back(one.text());
        const std::string why = refused_renderer_option(all.back());
        if (!why.empty())
            one.refuse(excerpt(all.back()) + ": " + why);
    }
    return all;
}

/// Options of print, lcd or replay.
Names command_options(const Located& object, const std::string& own_field)
{
    Names all;
    if (!object.has("options"))
        return all;
    for (const Located& one : object.field("options").list()) {
        const std::string word = one.text(), name = word.substr(0, word.find('='));
        const bool short_output = word.size() >= 2 && word[0] == '-' && word[1] == 'o';
        if (word.empty())
            one.refuse("an option of the command is expected");
        if (name == "--output" || short_output || name == "--html")
            one.refuse(excerpt(word) +
                       ": the batch names the output itself; the field \"format\" says its kind");
        for (const char* other : {"--printer", "--show", "--play", "--help", "--chart", "--even"})
            if (name == other)
                one.refuse(excerpt(word) +
                           ": a batch writes files, which are printed and shown afterwards");
        if (name == "--" + own_field)
            one.refuse(excerpt(word) + ": there is a field for it");
        if (word.rfind("--", 0) == 0 && name.find(' ') != std::string::npos)
            one.refuse(excerpt(word) +
                       ": each word stands by itself, as in \"--eye\", \"-30,0,120\"");
        all.push_back(word);
    }
    return all;
}

std::string format_in(const Located& object, const Names& formats)
{
    if (!object.has("format"))
        return formats[0];
    const std::string format = object.field("format").text();
    if (std::find(formats.begin(), formats.end(), format) == formats.end())
        object.field("format").refuse(list_of(formats) + ": one of these is expected");
    return format;
}

/// A paper, panel or preview; `field` is the one that says what it is.
BatchTarget read_target(const Located& object, const Names& formats, const char* field,
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

/// All lists of things that have names.
template <class Thing, class Read>
void read_list(const Located& root, const char* field, std::vector<Thing>& all, const Read& read)
{
    if (!root.has(field))
        return;
    std::set<std::string> names;
    for (const Located& object : root.field(field).list()) {
        all.push_back(read(object));
        if (!names.insert(all.back().name).second)
            object.field("name").refuse("there are two of the name " + all.back().name + " in " +
                                        field);
    }
}

template <class Thing> int index_of(const std::vector<Thing>& things, const std::string& name)
{
    for (std::size_t i = 0; i < things.size(); ++i)
        if (things[i].name == name)
            return int(i);
    return -1;
}

template <class Thing> Names names_of(const std::vector<Thing>& things)
{
    Names names;
    for (const Thing& thing : things)
        names.push_back(thing.name);
    return names;
}

/// A field that picks some things of a list by their names.
template <class Thing>
std::optional<Names> chosen(const Located& object, const char* field,
                            const std::vector<Thing>& things)
{
    if (!object.has(field))
        return std::nullopt;
    Names names;
    for (const Located& one : object.field(field).list()) {
        names.push_back(one.text());
        if (index_of(things, names.back()) < 0)
            one.refuse(excerpt(names.back()) + " is not among the manifest's " + field + ": " +
                       list_of(names_of(things)));
        if (std::count(names.begin(), names.end(), names.back()) > 1)
            one.refuse(names.back() + " stands here twice");
    }
    return names;
}

Targets targets_in(const Located& object, const Manifest& manifest)
{
    return {chosen(object, "papers", manifest.papers), chosen(object, "panels", manifest.panels),
            chosen(object, "previews", manifest.previews)};
}

BatchScene read_scene(const Located& object, const Manifest& manifest)
{
    object.allow({"name", "file", "options", "declare", "size", "inputs", "sheets", "papers",
                  "panels", "previews"});
    BatchScene scene;
    scene.name = name_in(object.field("name"));
    scene.file = readable_file(object.field("file"), manifest.folder);
    const std::string extension = extension_of(scene.file);
    if (extension != "pov" && extension != "ini")
        object.field("file").refuse("a scene, .pov or .ini, is expected");
    if (!can_be_quoted(scene.file))
        object.field("file").refuse(both_quotes);
    scene.options = renderer_options(object);
    if (object.has("declare"))
        for (const auto& [name, value] : object.field("declare").fields()) {
            const bool identifier =
                !name.empty() &&
                name.find_first_not_of(
                    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") ==
                    std::string::npos &&
                !(name[0] >= '0' && name[0] <= '9');
            if (!identifier || !value.json().is_number())
                value.refuse("a scene's identifier and a number are expected");
            scene.declare.emplace_back(name, value.json().dump());
        }
    scene.size = size_in(object);
    if (object.has("inputs"))
        for (const Located& one : object.field("inputs").list())
            scene.inputs.push_back(readable_file(one, manifest.folder));
    scene.sheets = chosen(object, "sheets", manifest.sheets);
    scene.targets = targets_in(object, manifest);
    return scene;
}

BatchSheet read_sheet(const Located& object, const Manifest& manifest)
{
    object.allow({"name", "camera", "options", "size", "papers", "panels", "previews"});
    BatchSheet sheet;
    sheet.name = name_in(object.field("name"));
    sheet.camera = object.field("camera").text();
    if (sheet.camera.find_first_not_of(" \t\n") == std::string::npos)
        object.field("camera").refuse(
            "the integral camera's words are expected, as in lens_sheet { ... } film { dpi 300 }");
    if (!can_be_quoted(sheet.camera))
        object.field("camera").refuse(both_quotes);
    sheet.options = renderer_options(object);
    sheet.size = size_in(object);
    sheet.targets = targets_in(object, manifest);
    return sheet;
}

void add_job(Manifest& manifest, const Located& place, BatchJob job, const Targets& own)
{
    const BatchScene& scene = manifest.scenes[std::size_t(job.scene)];
    const Targets sheet = job.sheet < 0 ? Targets()
                                        : manifest.sheets[std::size_t(job.sheet)].targets;
    const auto pick = [](const std::optional<Names>& first, const std::optional<Names>& second,
                         const std::optional<Names>& third, const Names& all) {
        return first ? *first : second ? *second : third ? *third : all;
    };
    job.papers = pick(own.papers, sheet.papers, scene.targets.papers, names_of(manifest.papers));
    job.panels = pick(own.panels, sheet.panels, scene.targets.panels, names_of(manifest.panels));
    job.previews = pick(own.previews, sheet.previews, scene.targets.previews,
                        names_of(manifest.previews));
    if (job.name.empty())
        job.name = scene.name +
                   (job.sheet < 0 ? "" : "-" + manifest.sheets[std::size_t(job.sheet)].name);
    job.line = place.line();
    if (index_of(manifest.jobs, job.name) >= 0)
        place.refuse("there are two jobs of the name " + job.name);
    if (manifest.jobs.size() == most_jobs)
        place.refuse("there are more than 10000 jobs");
    manifest.jobs.push_back(std::move(job));
}

void make_jobs(const Located& root, Manifest& manifest)
{
    const auto scenes = root.field("scenes").list();
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const Names sheets = manifest.scenes[i].sheets ? *manifest.scenes[i].sheets
                                                       : names_of(manifest.sheets);
        BatchJob job;
        job.scene = int(i);
        if (sheets.empty())
            add_job(manifest, scenes[i], job, {});
        for (const std::string& sheet : sheets) {
            job.sheet = index_of(manifest.sheets, sheet);
            add_job(manifest, scenes[i], job, {});
        }
    }
}

void read_jobs(const Located& list, Manifest& manifest)
{
    for (const Located& object : list.list()) {
        object.allow({"name", "scene", "sheet", "papers", "panels", "previews"});
        BatchJob job;
        if (object.has("name"))
            job.name = name_in(object.field("name"));
        job.scene = index_of(manifest.scenes, object.field("scene").text());
        if (job.scene < 0)
            object.field("scene").refuse("it is not among the manifest's scenes: " +
                                         list_of(names_of(manifest.scenes)));
        if (object.has("sheet")) {
            job.sheet = index_of(manifest.sheets, object.field("sheet").text());
            if (job.sheet < 0)
                object.field("sheet").refuse("it is not among the manifest's sheets: " +
                                             list_of(names_of(manifest.sheets)));
        }
        add_job(manifest, object, job, targets_in(object, manifest));
    }
}

void exclude_jobs(const Located& list, Manifest& manifest)
{
    for (const Located& one : list.list()) {
        const std::string pattern = one.text();
        const auto fits = [&](const BatchJob& job) {
            return fnmatch(pattern.c_str(), job.name.c_str(), 0) == 0;
        };
        const auto kept = std::remove_if(manifest.jobs.begin(), manifest.jobs.end(), fits);
        if (kept == manifest.jobs.end())
            one.refuse("no job is called " + excerpt(pattern) +
                       (manifest.jobs.empty()
                            ? ""
                            : "; there is, for one, " + manifest.jobs.front().name));
        manifest.jobs.erase(kept, manifest.jobs.end());
    }
}

} // namespace

std::string path_in(const std::string& folder, const std::string& name)
{
    return name.empty() || name[0] == '/' || folder.empty() ? name : folder + "/" + name;
}

Manifest read_manifest(const std::string& path)
{
    const Located root = Located::parse(display_name(path, "standard input"), read_file(path));
    root.allow({"output", "frames", "scenes", "sheets", "papers", "panels", "previews", "jobs",
                "exclude"});
    Manifest manifest;
    manifest.path = path;
    const auto slash = path.rfind('/');
    manifest.folder = slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
    const std::string output = root.field("output").text();
    if (output.empty())
        root.field("output").refuse("the name of a folder is expected");
    manifest.output = path_in(manifest.folder, output);
    if (!can_be_quoted(std::filesystem::absolute(manifest.output)))
        root.field("output").refuse(both_quotes);
    if (root.has("frames")) {
        const Located frames = root.field("frames");
        frames.allow({"format", "bits"});
        manifest.frame_format = format_in(frames, {"png", "exr"});
        if (frames.has("bits")) {
            manifest.frame_bits = frames.field("bits").whole(8, 16);
            if ((manifest.frame_bits != 8 && manifest.frame_bits != 16) ||
                manifest.frame_format != "png")
                frames.field("bits").refuse("8 or 16 is expected, of PNG");
        }
    }
    read_list(root, "papers", manifest.papers, [&](const Located& object) {
        object.allow({"name", "paper", "options", "format"});
        return read_target(object, {"pdf", "tiff", "png"}, "paper",
                           object.has("paper") ? object.field("paper").text() : "");
    });
    read_list(root, "panels", manifest.panels, [&](const Located& object) {
        object.allow({"name", "panel", "options", "format"});
        const Located panel = object.field("panel"); // a name that integral lcd knows, or a file
        const bool file = extension_of(panel.text()) == "json" ||
                          panel.text().find('/') != std::string::npos || panel.text().empty();
        return read_target(object, {"png", "tiff", "exr"}, "panel",
                           file ? readable_file(panel, manifest.folder) : panel.text());
    });
    read_list(root, "previews", manifest.previews, [&](const Located& object) {
        object.allow({"name", "options", "format"});
        return read_target(object, {"png", "exr", "tiff", "webp", "html"}, "", "");
    });
    read_list(root, "sheets", manifest.sheets,
              [&](const Located& object) { return read_sheet(object, manifest); });
    read_list(root, "scenes", manifest.scenes,
              [&](const Located& object) { return read_scene(object, manifest); });
    if (root.has("jobs"))
        read_jobs(root.field("jobs"), manifest);
    else
        make_jobs(root, manifest);
    if (root.has("exclude"))
        exclude_jobs(root.field("exclude"), manifest);
    if (manifest.jobs.empty())
        root.refuse("there are no jobs");
    return manifest;
}

} // namespace integral
