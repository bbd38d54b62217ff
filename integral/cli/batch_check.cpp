// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/batch_check.h"

#include "integral/base/file_bytes.h"
#include "integral/cli/command.h"
#include "integral/cli/lcd_command.h"
#include "integral/cli/print_options.h"
#include "integral/base/file_bytes.h"
#include "integral/cli/values.h"

#include <algorithm>

namespace integral {
namespace {

constexpr int most_pixels_a_side = 1000000;
constexpr double usual_view = 1000 * 1000; // pixels, where --size does not say them

/// A panel's file, or the name that integral lcd knows.
std::string file_of(const Manifest& manifest, const BatchTarget& panel)
{
    return extension_of(panel.what) == "json" ? path_in(manifest.folder, panel.what) : panel.what;
}

/// What a command reads of a target's options. Throws UsageError.
options::variables_map options_of(const Command& command, const BatchTarget& target, Names words)
{
    words.insert(words.end(), target.options.begin(), target.options.end());
    words.insert(words.end(), {"frame.png", "--output", "output." + target.format});
    const options::variables_map arguments = read_arguments(command, words);
    const auto inputs = inputs_of(arguments);
    if (inputs.size() > 1)
        throw UsageError(inputs[0] + ": an option of integral " + command.name + " is expected");
    return arguments;
}

/// Says where in the manifest stands what `check` finds wrong.
template <class Check>
void check_at(const std::string& place, const Command& command, const Check& check)
{
    try {
        check();
    } catch (const UsageError& error) {
        const std::string what = error.what();
        throw InputError(place + ": " + what +
                         (what.find(';') == std::string::npos
                              ? std::string("; see integral help ") + command.name
                              : ""));
    } catch (const InputError& error) {
        throw InputError(place + ": " + error.what());
    }
}

void check_panel(const BatchTarget& target, const std::string& panel)
{
    LcdOptions lcd;
    check_at(target.options_place, lcd_command, [&] {
        const auto arguments = options_of(lcd_command, target, {"--panel", panel});
        for (const char* option : {"list", "list-displays"})
            if (arguments[option].as<bool>())
                throw UsageError(std::string("--") + option + " makes no image");
        lcd = lcd_options(arguments);
        check_panel_options(lcd);
    });
    check_at(target.place, lcd_command, [&] {
        const Panel described = panel_of(lcd);
        if (described.calibration)
            for (const std::string& what : described.calibration->assumed)
                say("batch", target.place + ": " + what);
    });
}

} // namespace

void check_targets(const Manifest& manifest)
{
    for (const BatchTarget& paper : manifest.papers) {
        if (!paper.what.empty())
            check_at(paper.place, print_command, [&] { parse_paper_size(paper.what); });
        check_at(paper.options_place, print_command, [&] { options_of(print_command, paper, {}); });
    }
    for (const BatchTarget& panel : manifest.panels)
        check_panel(panel, file_of(manifest, panel));
    for (const BatchTarget& preview : manifest.previews)
        check_at(preview.options_place, replay_command,
                 [&] { options_of(replay_command, preview, {}); });
}

double output_pixels(const Manifest& manifest, const BatchStep& step, Vec2 pixel_pitch)
{
    const auto area = [](const options::variables_map& arguments, const char* option,
                         double otherwise) {
        if (!given(arguments, option))
            return otherwise;
        const PixelSize size = parse_size(option, text_of(arguments, option), most_pixels_a_side);
        return double(size.width) * size.height;
    };
    const auto called = [&](const std::vector<BatchTarget>& targets) {
        return *std::find_if(targets.begin(), targets.end(),
                             [&](const BatchTarget& one) { return one.name == step.target; });
    };
    try {
        if (step.kind == StepKind::print) {
            const BatchTarget paper = called(manifest.papers);
            if (paper.what.empty() || paper.format == "pdf")
                return 0;
            const Paper size = parse_paper_size(paper.what);
            return size.width / pixel_pitch.x * size.height / pixel_pitch.y;
        }
        if (step.kind == StepKind::panel) {
            const BatchTarget target = called(manifest.panels);
            const auto arguments = options_of(lcd_command, target,
                                              {"--panel", file_of(manifest, target)});
            const Panel panel = panel_of(lcd_options(arguments));
            constexpr double views = 4; // of --size, in memory beside the image
            return double(panel.film.width) * panel.film.height +
                   views * area(arguments, "size", 0);
        }
        if (step.kind == StepKind::preview) {
            const options::variables_map arguments = options_of(replay_command,
                                                                called(manifest.previews), {});
            return area(arguments, "size", usual_view) *
                   area(arguments, "grid", given(arguments, "stereo") ? 2 : 1);
        }
    } catch (const UsageError&) { // its command says what is wrong
    } catch (const InputError&) {
    }
    return usual_view;
}

} // namespace integral
