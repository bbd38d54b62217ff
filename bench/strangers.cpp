// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares anti-aliasing with brute force on scenes not made for this project: every sample scene
// of POV-Ray's that renders in reasonable time, unedited, behind two sheets put on with
// Integral_Camera. Each frame is measured against two converged frames of independent samples. A
// run continues an interrupted one, and tries again what was left out. `strangers -o FOLDER` writes
// strangers.csv, .md, .svg and .png to a folder in FOLDER that is named after the frames' size.
#include "bench/strangers.h"

#include "bench/program.h"
#include "bench/views.h"

#include "integral/base/file_bytes.h"
#include "integral/io/image_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <regex>
#include <zlib.h>

namespace {

namespace options = boost::program_options;
namespace files = std::filesystem;
using namespace integral;
using namespace integral::bench;

constexpr double short_run = 1; // seconds: a frame that takes less is rendered twice for timing

options::options_description make_options()
{
    options::options_description all("Options");
    all.add_options()("output,o", options::value<std::string>()->value_name("FOLDER"),
                      "where tables, plot and frames are written, and found again")(
        "size", options::value<std::string>()->value_name("WxH")->default_value("240x160"),
        "pixels of the frames, at 300 dpi")(
        "only", options::value<std::vector<std::string>>()->value_name("TEXT"),
        "only scenes whose path has this text in it; may be given again")(
        "one-in", options::value<int>()->value_name("N")->default_value(1),
        "only about one in N scenes: those whose path's CRC-32 is a multiple of N")(
        "longest", options::value<int>()->value_name("SECONDS")->default_value(120),
        "leave a scene out if its two converged frames would take longer than this")(
        "report", "measure nothing: write the page of what has been measured")(
        "renderer", options::value<std::string>()->value_name("FILE"),
        "povray-integral (default: the one built beside this program)")(
        "scenes", options::value<std::string>()->value_name("FOLDER"),
        "sample scenes (default: those of this build)")("help", "print this");
    return all;
}

/// Whether a scene belongs to the sample of about one in `number` scenes. A hash of its path
/// decides, so that the choice is arbitrary but the same in every run.
bool is_in_sample(const std::string& scene, int number)
{
    const auto* bytes = reinterpret_cast<const Bytef*>(scene.data());
    return crc32(0, bytes, uInt(scene.size())) % uLong(number) == 0;
}

/// Returns the folder's scenes except our own, as sorted paths in it without the extension.
std::vector<std::string> scenes_in(const files::path& folder, const std::vector<std::string>& only,
                                   int one_in)
{
    std::vector<std::string> scenes;
    for (const auto& entry : files::recursive_directory_iterator(folder)) {
        const files::path path = entry.path().lexically_relative(folder);
        if (path.extension() != ".pov" || *path.begin() == "integral")
            continue;
        const std::string name = files::path(path).replace_extension().string();
        const auto is_in_name = [&](const std::string& text) {
            return name.find(text) != std::string::npos;
        };
        if ((only.empty() || std::any_of(only.begin(), only.end(), is_in_name)) &&
            is_in_sample(name, one_in))
            scenes.push_back(name);
    }
    std::sort(scenes.begin(), scenes.end());
    return scenes;
}

/// A scene's text without its comments.
std::string without_comments(const std::string& text)
{
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const bool line = text.compare(at, 2, "//") == 0;
        if (!line && text.compare(at, 2, "/*") != 0) {
            result += text[at++];
            continue;
        }
        const std::size_t end = text.find(line ? "\n" : "*/", at + 2);
        at = end == std::string::npos ? text.size() : end + (line ? 0 : 2);
    }
    return result;
}

/// Returns the kind of a scene's lighting, from its own text (without included files) and from the
/// statistics of a render.
std::string kind_of(const std::string& scene_text, const std::string& statistics)
{
    static const std::regex dear("\\barea_light\\b|\\bradiosity\\s*\\{"),
        bent("\n(Reflected|Refracted) Rays: +[1-9]");
    if (std::regex_search(without_comments(scene_text), dear))
        return "area lights or radiosity";
    return std::regex_search(statistics, bent) ? "mirrors or glass" : "matte under point lights";
}

/// Measures one scene behind one sheet.
class Stranger {
public:
    Stranger(Renderer renderer, const std::string& scene, const Sheet& sheet, int longest,
             StrangersTable& table)
        : renderer_(std::move(renderer)),
          file_(files::path(scene).filename().string()),
          name_(scene + "-" + sheet.name),
          key_(scene, sheet.name),
          sheet_(sheet),
          longest_(longest),
          table_(table)
    {
        std::replace(name_.begin(), name_.end(), '/', '-');
        renderer_.scene_folder = (files::path(renderer_.scene_folder) / scene).parent_path();
    }

    /// Throws std::runtime_error if the scene cannot be rendered or takes too long.
    void measure(const std::function<void(const std::string&)>& say)
    {
        std::vector<Setting> settings = brute_force_settings();
        for (const auto* more : {&antialias_settings(), &settings_without_reconstruction()})
            settings.insert(settings.end(), more->begin(), more->end());
        for (const Setting& setting : settings) {
            if (table_.find(key_, setting.full_name()))
                continue;
            make_references();
            const StrangersRow row = measured(setting);
            table_.add(key_, setting.full_name(), row);
            char line[200];
            std::snprintf(line, sizeof line, "%s %s: %-36s %8.3f s   error %.4f   estimate %.4f",
                          key_.first.c_str(), key_.second.c_str(), setting.full_name().c_str(),
                          row.cpu_seconds, row.error, row.estimate ? row.estimate->rms : 0.0);
            say(line);
        }
    }

    /// The result of kind_of; nothing if there are no statistics of a render.
    std::optional<std::string> kind() const
    {
        const std::string log = renderer_.work_folder + "/" + name_ + ".log";
        if (!files::exists(log))
            return {};
        return kind_of(read_file(renderer_.scene_folder + "/" + file_ + ".pov"), read_file(log));
    }

private:
    RenderCost render(const Setting& setting, const std::string& name, const char* audit)
    {
        std::vector<std::string> options = setting.options;
        options.push_back(std::string("Integral_Audit=") + audit);
        return renderer_.render(file_, name, camera_words(sheet_, setting), options);
    }

    /// Makes two converged frames with independent samples and independent gathering of radiosity.
    void make_references()
    {
        if (!references_.empty())
            return;
        std::vector<Frame> both;
        for (const char* number : {"1", "2"}) {
            const std::string name = name_ + "-reference-" + number, file = renderer_.picture(name);
            Setting setting = brute_force_settings().back();
            setting.options.push_back(std::string("Integral_Seed=100") + number);
            if (!files::exists(file)) {
                const double plain = render(brute_force_settings()[0], name_, "off").cpu_seconds;
                constexpr int samples = 256; // of both
                if (samples * plain > longest_)
                    throw std::runtime_error("its converged frames would take " +
                                             std::to_string(int(samples * plain)) + " s");
                render(setting, name, "off");
            }
            both.push_back(read_frame_with_metadata(file));
        }
        references_ = std::move(both);
        floor_ = lit_rmse(references_[0], references_[1]) / 2;
    }

    StrangersRow measured(const Setting& setting)
    {
        StrangersRow row;
        row.cpu_seconds = render(setting, name_, "off").cpu_seconds;
        if (row.cpu_seconds < short_run)
            row.cpu_seconds = std::min(row.cpu_seconds, render(setting, name_, "off").cpu_seconds);
        render(setting, name_, "on");
        const Frame frame = read_frame_with_metadata(renderer_.picture(name_));
        files::remove(renderer_.picture(name_));
        row.estimate = frame.metadata->render->error;
        row.floor = floor_;
        row.error = std::sqrt(
            std::max(0.0, lit_squared_error(frame, references_[0], references_[1])));
        return row;
    }

    Renderer renderer_;
    std::string file_, name_;
    StrangersTable::Key key_;
    Sheet sheet_;
    int longest_;
    StrangersTable& table_;
    std::vector<Frame> references_; ///< two, or none yet
    double floor_ = 0;              ///< error of the mean of both
};

void write_page(const StrangersTable& table, const std::string& folder)
{
    write_file(folder + "/strangers.md", strangers_page(table));
    if (!table.panels().empty())
        write_strangers_plot(table, folder);
}

int run(const options::variables_map& arguments)
{
    if (!arguments.count("output"))
        throw UsageError("-o FOLDER is missing");
    const auto path = [&](const char* option, const files::path& usual) {
        return files::absolute(arguments.count(option) ? arguments[option].as<std::string>()
                                                       : usual.string())
            .lexically_normal();
    };
    Renderer renderer;
    renderer.program = path("renderer", own_folder() / "../bin/povray-integral").string();
    renderer.scene_folder = path("scenes", own_folder() / "../povray/distribution/scenes").string();
    const std::string size = arguments["size"].as<std::string>();
    if (std::sscanf(size.c_str(), "%5dx%5d", &renderer.width, &renderer.height) != 2 ||
        renderer.width < 40 || renderer.height < 40)
        throw UsageError("--size " + size + ": WIDTHxHEIGHT is expected, each at least 40");
    if (!files::is_directory(renderer.scene_folder))
        throw UsageError(renderer.scene_folder +
                         ": there are no scenes here; name their folder with --scenes");
    const int longest = renderer.patience = arguments["longest"].as<int>();
    if (longest < 1)
        throw UsageError("--longest " + std::to_string(longest) +
                         ": at least 1 second is expected");
    const int one_in = arguments["one-in"].as<int>();
    if (one_in < 1)
        throw UsageError("--one-in " + std::to_string(one_in) + ": at least 1 is expected");

    const std::string folder = files::absolute(arguments["output"].as<std::string>()).string() +
                               "/" + size;
    renderer.work_folder = folder + "/frames";
    files::create_directories(renderer.work_folder);
    StrangersTable table(folder + "/strangers.csv");
    const auto only = arguments.count("only") ? arguments["only"].as<std::vector<std::string>>()
                                              : std::vector<std::string>();
    const auto say = [](const std::string& line) { std::cout << line << std::endl; };
    // Scenes that write files write them here.
    files::current_path(renderer.work_folder);
    for (const std::string& scene : scenes_in(renderer.scene_folder, only, one_in)) {
        if (arguments.count("report"))
            break;
        try {
            for (const Sheet& sheet : sheets()) {
                Stranger stranger(renderer, scene, sheet, longest, table);
                stranger.measure(say);
                if (const auto kind = stranger.kind(); kind && !table.kind(scene))
                    table.set_kind(scene, *kind);
            }
        } catch (const std::runtime_error& error) {
            table.leave_out(scene, error.what());
            say(scene + ": left out: " + error.what());
        }
        write_page(table, folder);
    }
    write_page(table, folder);
    say(folder + "/strangers.md is written");
    return 0;
}

} // namespace

int main(int count, char** words)
{
    return status_of("strangers", [&] {
        const options::options_description all = make_options();
        const options::variables_map arguments = parsed(count, words, all);
        if (!arguments.count("help"))
            return run(arguments);
        std::cout
            << "strangers -o FOLDER [--size WxH] [--only TEXT] [--one-in N] [--longest SECONDS]\n\n"
            << all;
        return 0;
    });
}
