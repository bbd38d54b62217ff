// SPDX-License-Identifier: AGPL-3.0-or-later
// integral tune: error against seconds of settings, for this scene and machine.
#include "integral/base/json.h"
#include "integral/batch/renderer.h"
#include "integral/batch/renderer_options.h"
#include "integral/batch/tune.h"
#include "integral/batch/tune_report.h"
#include "integral/cli/command.h"
#include "integral/cli/progress.h"
#include "integral/cli/values.h"
#include "integral/io/image_file.h"
#include "integral/io/plot.h"

namespace integral {
namespace {

struct TuneOptions : CommonOptions {
    std::optional<std::string> target_error, seconds, plot, output;
    bool json = false, csv = false, render = false;
};

void declare(options::options_description& all, TuneOptions& o)
{
    add(all, "target-error", o.target_error, "E",
        "the estimated RMS error that the frame may have, 1 is full scale, as 0.01: names the "
        "fastest setting");
    add(all, "seconds", o.seconds, "S",
        "how long the render may take: names the setting with the least error");
    add(all, "plot", o.plot, "FILE", "draw error against seconds, to FILE.svg or FILE.png");
    add(all, "json", o.json, "print the figures as JSON");
    add(all, "csv", o.csv, "print the settings' errors and seconds as comma-separated values");
    add(all, "render", o.render, "then render the whole frame with the setting named");
    add(all, "output,o", o.output, "FILE", "print to FILE instead of standard output");
}

TuneGoal goal_of(const TuneOptions& o)
{
    TuneGoal goal;
    if (o.target_error) {
        goal.error = parse_number("target-error", *o.target_error, "a number");
        if (!(*goal.error > 0 && *goal.error < 1))
            throw UsageError("--target-error " + *o.target_error +
                             ": a number between 0 and 1 (full scale) is expected, as 0.01");
    }
    if (o.seconds)
        read_positive("seconds", o.seconds, goal.seconds.emplace());
    return goal;
}

int run(const TuneOptions& o)
{
    const TuneGoal goal = goal_of(o);
    if (o.render && !goal.error && !goal.seconds)
        throw UsageError("--render needs a target: --target-error 0.02, or --seconds 60");
    const std::string& scene = o.inputs[0];
    const Arguments words(o.inputs.begin() + 1, o.inputs.end());
    if (o.csv && o.json)
        throw UsageError("--csv and --json are two forms of the output; give one of them");
    if (o.plot)
        plot_format(*o.plot);
    check_outputs({o.plot, o.output});
    const TuneResult result = tune(scene, words, goal, progress_bar("tune"));
    if (o.plot)
        write_plot(tune_plot(scene, result), *o.plot);
    const std::string text = o.json  ? tune_json(scene, words, goal, result).dump(2) + "\n"
                             : o.csv ? tune_csv(result)
                                     : tune_text(scene, words, goal, result);
    // Standard output may be reserved for the picture.
    if (o.render && !o.output && value_of_option(words, "output_file_name", "o") == "-")
        std::fputs(text.c_str(), stderr);
    else
        print_result(o.output, text);
    if (o.render && !result.best)
        say("tune", "no picture was rendered, as none of the settings reaches the target; ask for "
                    "what the nearest one reaches");
    if (o.render && result.best) {
        std::fflush(stdout);
        become_renderer(tuned_words(scene, words, result, result.points[*result.best].setting));
    }
    return result.best || (!goal.error && !goal.seconds) ? exit_done : exit_check_failed;
}

} // namespace

const Command tune_command = {
    "tune",
    "which sampling settings a scene needs: error against seconds on this machine",
    "SCENE [+W +H ...] [--target-error E | --seconds S] [--render] [--plot FILE.svg]",
    R"(Renders some bands of the scene's frame at a ladder of settings, with the size, the camera and
the other options of povray-integral that follow SCENE; prints each setting's estimated error
and the time that the whole frame would take; and names the setting for a target, as a command
line to paste, or renders the frame with it. The exit status is 1 if no setting reaches the
target.
)",
    1,
    1000,
    described<TuneOptions>,
    run_with<TuneOptions, run>};

} // namespace integral
