// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/tune_report.h"

#include "integral/base/json.h"
#include "integral/base/number_text.h"
#include "integral/base/text_columns.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

bool antialiases(const TuneSetting& setting) { return setting.options[0] != "-A"; }

/// "pixel_samples 2 beam_samples 4" or "+A0.1 +AM2 +R5".
std::string name_of(const TuneSetting& setting)
{
    if (!antialiases(setting))
        return setting.camera == "pixel_samples 1 beam_samples 1" ? "one ray a pixel"
                                                                  : setting.camera;
    std::string name;
    for (const std::string& option : setting.options)
        name += (name.empty() ? "" : " ") + option;
    return name;
}

/// "34.5 s", "12 min 5 s", "3 h 20 min".
std::string time_text(double seconds)
{
    if (seconds < 100)
        return with_digits(seconds, 3) + " s";
    const auto whole = [](double value) { return std::to_string((long long)value); };
    if (seconds < 6000)
        return whole(seconds / 60) + " min " + whole(std::fmod(seconds, 60)) + " s";
    return whole(seconds / 3600) + " h " + whole(std::fmod(seconds, 3600) / 60) + " min";
}

/// The goal in words: "an error of at most 0.01 within 60 s".
std::string goal_text(const TuneGoal& goal)
{
    std::string text;
    if (goal.error)
        text = "an error of at most " + with_digits(*goal.error, 3);
    if (goal.seconds)
        text += (text.empty() ? "the least error" : "") + std::string(" within ") +
                time_text(*goal.seconds);
    return text;
}

/// The point nearest to a goal that none reaches: the one with the least error, or the fastest if
/// time alone is the goal.
const TunePoint& nearest(const TuneGoal& goal, const TuneResult& result)
{
    return *std::min_element(result.points.begin(), result.points.end(),
                             [&](const TunePoint& a, const TunePoint& b) {
                                 return goal.error ? counted_error(a.error) < counted_error(b.error)
                                                   : a.seconds < b.seconds;
                             });
}

} // namespace

std::string tune_text(const std::string& scene, const std::vector<std::string>& options,
                      const TuneGoal& goal, const TuneResult& result)
{
    std::string text = scene + ", " + size_text(result.width, result.height) +
                       " pixels, of which " + std::to_string(result.rows) +
                       " rows were rendered at each setting;\n"
                       "error (RMS, 1 is full scale) and time are foretold for the whole frame on "
                       "this machine, " +
                       time_text(result.parsing) + " of it\nfor parsing and writing.\n\n" +
                       "  setting                                 error   95% from  to          "
                       "time\n";
    for (const TunePoint& point : result.points) {
        std::string row = "  " + name_of(point.setting);
        row.resize(36, ' ');
        text += row + right_aligned(with_decimals(point.error.rms, 4), 11) +
                right_aligned(with_decimals(point.error.low, 4), 10) + "  " +
                with_decimals(point.error.high, 4) + right_aligned(time_text(point.seconds), 14) +
                "\n";
    }
    if (!goal.error && !goal.seconds)
        return text;
    const TunePoint& chosen = result.best ? result.points[*result.best] : nearest(goal, result);
    text += "\nFor " + goal_text(goal) + ": ";
    if (!result.best)
        text += "none of these; the nearest is ";
    return text + name_of(chosen.setting) + ", error " + with_decimals(chosen.error.rms, 4) +
           " in " + time_text(chosen.seconds) + ":\n  " +
           tuned_command(scene, options, result, chosen.setting) + "\n";
}

Json tune_json(const std::string& scene, const std::vector<std::string>& options,
               const TuneGoal& goal, const TuneResult& result)
{
    Json points = Json::array();
    for (const TunePoint& point : result.points)
        points.push_back({{"setting", name_of(point.setting)},
                          {"error", point.error.rms},
                          {"error_low", point.error.low},
                          {"error_high", point.error.high},
                          {"seconds", point.seconds},
                          {"processor_seconds", point.processor},
                          {"command", tuned_command(scene, options, result, point.setting)}});
    const auto or_null = [](std::optional<double> v) { return v ? Json(*v) : Json(nullptr); };
    return {{"scene", scene},
            {"width", result.width},
            {"height", result.height},
            {"rows", result.rows},
            {"parsing_seconds", result.parsing},
            {"target_error", or_null(goal.error)},
            {"target_seconds", or_null(goal.seconds)},
            {"settings", points},
            {"best", result.best ? points[*result.best] : Json(nullptr)}};
}

std::string tune_csv(const TuneResult& result)
{
    std::string text = "setting,error,error_low,error_high,seconds,processor_seconds\n";
    for (const TunePoint& point : result.points) {
        text += name_of(point.setting);
        for (const double value :
             {point.error.rms, point.error.low, point.error.high, point.seconds, point.processor})
            text += "," + with_digits(value, 6);
        text += "\n";
    }
    return text;
}

Plot tune_plot(const std::string& scene, const TuneResult& result)
{
    Plot plot;
    plot.title = "Error against seconds: " + scene;
    plot.subtitle = size_text(result.width, result.height) + " pixels, foretold from " +
                    std::to_string(result.rows) + " rows";
    plot.x.label = "seconds of the whole frame";
    plot.y.label = "RMS error (1 is full scale)";
    plot.x.logarithmic = plot.y.logarithmic = true;
    PlotSeries samples, antialiased;
    samples.label = "pixel_samples and beam_samples";
    antialiased.label = "+A";
    for (const TunePoint& point : result.points) {
        PlotSeries& series = antialiases(point.setting) ? antialiased : samples;
        series.style = PlotSeries::Style::line_and_points;
        series.x.push_back(point.seconds);
        series.y.push_back(point.error.rms);
        series.low.push_back(point.error.low);
        series.high.push_back(point.error.high);
        series.names.push_back(antialiases(point.setting) ? point.setting.options[0]
                                                          : name_of(point.setting));
    }
    plot.series = {samples, antialiased};
    return plot;
}

} // namespace integral
