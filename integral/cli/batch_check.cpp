// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/batch_check.h"

#include "integral/base/file_bytes.h"
#include "integral/cli/command.h"
#include "integral/cli/lcd_options.h"
#include "integral/cli/print_options.h"
#include "integral/cli/replay_options.h"
#include "integral/cli/values.h"

namespace integral {
namespace {

constexpr int most_pixels_a_side = 1000000;
constexpr double usual_view = 1000 * 1000; // pixels, if --size is not given

/// A panel's file, or its name for integral lcd.
std::string file_of(const Manifest& manifest, const BatchTarget& panel)
{
    return extension_of(panel.what) == "json" ? path_in(manifest.folder, panel.what) : panel.what;
}

/// Reads a target's options as its command does, to check them. Puts the words `own` before them,
/// and sample names of an input and an output after them. Throws UsageError.
template <class Options>
Options options_of(const Command& command, const BatchTarget& target, Arguments own = {})
{
    own.insert(own.end(), target.options.begin(), target.options.end());
    own.insert(own.end(), {"frame.png", "--output", "output." + target.format});
    Options read = read_options<Options>(own);
    if (read.inputs.size() > 1) // a word that is no option
        throw UsageError(read.inputs[0] + ": an option of integral " + command.name +
                         " is expected");
    return read;
}

LcdOptions lcd_options_of(const BatchTarget& target, const std::string& panel)
{
    return options_of<LcdOptions>(lcd_command, target, {"--panel", panel});
}

/// Calls `check` and turns its exceptions into InputError, prefixed by the place in the manifest.
template <class Check>
void check_at(const std::string& place, const Command& command, const Check& check)
{
    try {
        check();
    } catch (const UsageError& error) {
        const std::string what = error.what();
        const bool has_help = what.find(';') != std::string::npos;
        throw InputError(place + ": " + what +
                         (has_help ? "" : std::string("; see integral help ") + command.name));
    } catch (const InputError& error) {
        throw InputError(place + ": " + error.what());
    }
}

void check_panel(const BatchTarget& target, const std::string& panel)
{
    LcdRequest request;
    check_at(target.options_place, lcd_command, [&] {
        const LcdOptions read = lcd_options_of(target, panel);
        if (read.list || read.list_displays)
            throw UsageError(std::string("--") + (read.list ? "list" : "list-displays") +
                             " makes no image");
        request = lcd_request(read);
        check_panel_options(read, request);
    });
    check_at(target.place, lcd_command, [&] {
        const Panel described = panel_of(request);
        if (described.calibration)
            for (const std::string& what : described.calibration->assumed)
                say("batch", target.place + ": " + what);
    });
}

/// Pixels of WIDTHxHEIGHT; `otherwise` if the option is not given.
double area_of(const char* option, const std::optional<std::string>& text, double otherwise)
{
    if (!text)
        return otherwise;
    const PixelSize size = parse_size(option, *text, most_pixels_a_side);
    return double(size.width) * size.height;
}

double page_pixels(const BatchTarget& paper, Vec2 pixel_pitch)
{
    if (paper.what.empty() || paper.format == "pdf")
        return 0;
    const Paper size = parse_paper_size(paper.what);
    return size.width / pixel_pitch.x * size.height / pixel_pitch.y;
}

double panel_pixels(const BatchTarget& target, const std::string& file)
{
    constexpr double views = 4; // as large as --size, in memory with the image
    const LcdRequest request = lcd_request(lcd_options_of(target, file));
    const Panel panel = panel_of(request);
    return double(panel.film.width) * panel.film.height +
           views * request.image.width * request.image.height;
}

double preview_pixels(const BatchTarget& preview)
{
    const auto read = options_of<ReplayOptions>(replay_command, preview);
    return area_of("size", read.size, usual_view) * area_of("grid", read.grid, read.stereo ? 2 : 1);
}

} // namespace

void check_targets(const Manifest& manifest)
{
    for (const BatchTarget& paper : manifest.papers) {
        if (!paper.what.empty())
            check_at(paper.place, print_command, [&] { parse_paper_size(paper.what); });
        check_at(paper.options_place, print_command,
                 [&] { options_of<PrintOptions>(print_command, paper); });
    }
    for (const BatchTarget& panel : manifest.panels)
        check_panel(panel, file_of(manifest, panel));
    for (const BatchTarget& preview : manifest.previews)
        check_at(preview.options_place, replay_command,
                 [&] { options_of<ReplayOptions>(replay_command, preview); });
}

double output_pixels(const Manifest& manifest, const BatchStep& step, Vec2 pixel_pitch)
{
    const std::size_t target = std::size_t(step.target);
    try {
        if (step.kind == StepKind::print)
            return page_pixels(manifest.papers[target], pixel_pitch);
        if (step.kind == StepKind::panel)
            return panel_pixels(manifest.panels[target],
                                file_of(manifest, manifest.panels[target]));
        if (step.kind == StepKind::preview)
            return preview_pixels(manifest.previews[target]);
    } catch (const UsageError&) { // reported by the command itself
    } catch (const InputError&) {
    }
    return usual_view;
}

} // namespace integral
