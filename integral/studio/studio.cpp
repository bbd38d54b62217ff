// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/studio/studio.h"

#include "integral/base/file_bytes.h"
#include "integral/base/json.h"
#include "integral/io/image_file.h"
#include "integral/io/markup.h"
#include "integral/print/frame_print.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace integral {
namespace {

/// The number, at least 1, after `start` at the end of a path; empty for other paths.
std::optional<int> number_after(const std::string& start, const std::string& path)
{
    int number = 0;
    if (path.compare(0, start.size(), start) != 0)
        return std::nullopt;
    const char *const from = path.data() + start.size(), *const to = path.data() + path.size();
    const auto read = std::from_chars(from, to, number);
    if (read.ec != std::errc() || read.ptr != to || number < 1)
        return std::nullopt;
    return number;
}

std::string exact_bytes(const ExactDraft& exact)
{
    std::string document = to_json(*exact.frame.metadata);
    std::replace(document.begin(), document.end(), '\n', ' ');
    std::string bytes = padded_line(std::move(document));
    const Image& image = exact.frame.image;
    if (image.channels != 3 && image.channels != 4)
        throw std::runtime_error("the scene's picture has no colours; leave Grayscale_Output out");
    for (int y = 0; y < image.height; ++y) {
        const unsigned char* row = row_bytes(image, y);
        if (image.channels == 4) {
            bytes.append(reinterpret_cast<const char*>(row), std::size_t(4) * image.width);
            continue;
        }
        for (int x = 0; x < image.width; ++x, row += 3) {
            bytes.append(reinterpret_cast<const char*>(row), 3);
            bytes += char(-1); // opaque
        }
    }
    return bytes;
}

ServerAnswer bytes_answer(std::string bytes)
{
    return {200, std::move(bytes), "application/octet-stream"};
}

ServerAnswer json_answer(std::string text) { return {200, std::move(text), "application/json"}; }

/// A document on one line. Bytes of files' names that are not UTF-8 become U+FFFD.
std::string text_of(const Json& document)
{
    return document.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Whether a frame has a panel's pixels and lenses.
bool is_of_panel(const FrameMetadata& made, const Panel& panel)
{
    constexpr double tolerance = 1e-4;
    const FrameMetadata own = frame_geometry(panel);
    return made.film.width == own.film.width && made.film.height == own.film.height &&
           std::fabs(made.sheet.pitch / own.sheet.pitch - 1) < tolerance &&
           std::fabs(made.sheet.slant - own.sheet.slant) < tolerance;
}

} // namespace

Studio::Studio(const StudioInput& input, const PlacementSettings& first, StudioRenders& renders,
               PanelWindow& window)
    : input_(input), first_(first), renders_(renders), window_(window)
{
}

/// The name of the print's or the panel's picture, for the working folder.
std::string Studio::print_name(const PlacementSettings& settings) const
{
    return input_.name() + (settings.panel ? "-on-panel.png" : "-on-sheet.png");
}

std::optional<ServerAnswer> Studio::answer(const ServerRequest& request)
{
    if (request.is_post)
        try {
            return post(request);
        } catch (const std::invalid_argument& error) {
            return ServerAnswer{400, error.what(), "text/plain; charset=utf-8"};
        }
    if (request.path == "/")
        return ServerAnswer{200, studio_page(input_, first_, request)};
    if (request.path == "/events") {
        ServerAnswer events;
        const auto listener = std::make_shared<StudioRenders::Listener>(renders_);
        events.next_event = [listener] { return listener->next_state(); };
        return events;
    }
    if (request.path == "/probe")
        if (const auto probe = renders_.probe())
            return bytes_answer(probe_bytes(*probe));
    if (request.path == "/exact")
        if (const auto exact = renders_.exact())
            return bytes_answer(exact_bytes(*exact));
    return std::nullopt;
}

std::optional<ServerAnswer> Studio::post(const ServerRequest& request)
{
    if (request.path == "/figures")
        return json_answer(figures(request.body));
    if (request.path == "/save")
        return json_answer(save(settings_from_json(request.body)));
    if (request.path == "/page")
        return json_answer(page(request.body));
    if (request.path == "/show")
        return json_answer(show(settings_from_json(request.body)));
    if (request.path == "/print") {
        const PlacementSettings settings = possible_settings(request.body);
        renders_.request_print(settings, print_name(settings));
    } else if (request.path == "/stop-print")
        renders_.stop_print();
    else if (const auto to_stop = number_after("/stop/", request.path))
        renders_.stop_exact(*to_stop);
    else if (const auto requested = number_after("/exact/", request.path))
        renders_.request_exact(*requested, possible_settings(request.body));
    else
        return std::nullopt;
    return json_answer("{}");
}

/// Reads settings, and checks that they make a frame. Throws std::invalid_argument.
PlacementSettings Studio::possible_settings(const std::string& text) const
{
    const PlacementSettings settings = settings_from_json(text);
    const std::shared_ptr<const Probe> probe = renders_.probe();
    frame_of_settings(settings, probe ? &probe->depths : nullptr);
    return settings;
}

std::string Studio::figures(const std::string& text) const
{
    const std::shared_ptr<const Probe> probe = renders_.probe();
    const DepthFrame* const depths = probe ? &probe->depths : nullptr;
    PlacementSettings settings = text.empty() ? first_ : settings_from_json(text);
    if (!(settings.print.x > 0)) // not given
        settings.print = print_of_aspect(probe ? probe->request.aspect : 4.0 / 3);
    Json figures = settings_figures(settings, depths);
    figures["words"] = input_.words(settings, frame_of_settings(settings, depths));
    figures["settings"] = json_of(settings);
    return text_of(figures);
}

/// Writes the file that the print is made with.
std::string Studio::save(const PlacementSettings& settings) const
{
    const std::shared_ptr<const Probe> probe = renders_.probe();
    if (!probe)
        throw std::invalid_argument("the scene has no probe yet; save again when its picture is "
                                    "shown");
    const SavedPlacement saved = input_.save(settings, frame_of_settings(settings, &probe->depths),
                                             print_name(settings));
    return text_of({{"file", saved.file}, {"command", saved.command}});
}

/// Shows the print on the panel. Panels are known, or the one that the user named at the start: no
/// other name becomes a file's.
std::string Studio::show(const PlacementSettings& settings) const
{
    const std::string print = renders_.print();
    if (print.empty())
        throw std::invalid_argument("there is no image for the panel yet; render it first");
    if (!settings.panel)
        throw std::invalid_argument("a print is not shown on a panel; choose a panel");
    const std::string& panel = settings.panel->name;
    if (!panel_named(panel) && !(first_.panel && first_.panel->name == panel))
        throw std::invalid_argument("panel is none of this page; choose one in its list");
    const FrameMetadata made = read_metadata(print);
    if (!is_of_panel(made, *settings.panel))
        throw std::invalid_argument(print + " is not of this panel; render the panel's image "
                                            "first");
    const std::string problem = window_.open(print, panel);
    if (!problem.empty())
        throw std::invalid_argument(problem);
    return Json{{"command", "integral lcd " + for_shell(print) + " --panel " + for_shell(panel) +
                                " --show auto"}}
        .dump();
}

/// Writes the print's page. `paper`: its name, or empty.
std::string Studio::page(const std::string& paper) const
{
    const std::string print = renders_.print();
    if (print.empty())
        throw std::invalid_argument("there is no print yet; render the print first");
    const std::string file = print.substr(0, print.rfind('.')) + ".pdf";
    FrameReader frame(print);
    frame.require_metadata();
    const FrameMetadata& metadata = *frame.frame().metadata;
    PrintSettings settings;
    settings.title = print_title(print, metadata);
    settings.pixel_pitch = metadata.film.pixel_pitch;
    PageRequest& page = settings.page;
    page.crop_marks = page.registration_marks = page.axis_marks = true;
    std::string command = "integral print " + for_shell(print) + " -o " + for_shell(file) +
                          " --marks all";
    if (!paper.empty()) {
        const auto named = paper_named(paper);
        if (!named)
            throw std::invalid_argument("there is no such paper; take " + paper_names());
        page.paper = paper_for(*named, metadata.film);
        command += " --paper " + paper;
    }
    FramePrint(frame, settings).write(file);
    return text_of({{"file", file}, {"command", command}});
}

} // namespace integral
