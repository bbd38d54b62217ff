// SPDX-License-Identifier: AGPL-3.0-or-later
#include "bench/strangers.h"

#include "integral/base/file_bytes.h"
#include "integral/io/plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <sstream>

namespace integral::bench {

namespace {

std::string number(double value, const char* format)
{
    char text[40];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

/// Type of speed_up and time_to_that_without.
using Figure = std::optional<double>(const StrangersPanel& panel, const Setting& setting);

/// Returns a figure at one threshold over all scenes and sheets, in rising order; with `kind`, over
/// the scenes of that kind.
std::vector<double> figures(const StrangersTable& table, const Setting& setting, Figure figure,
                            const std::string& kind = {})
{
    std::vector<double> all;
    for (const auto& [key, panel] : table.panels()) {
        const std::string* of_scene = table.kind(key.first);
        if (!kind.empty() && (!of_scene || *of_scene != kind))
            continue;
        if (const auto value = figure(panel, setting))
            all.push_back(*value);
    }
    std::sort(all.begin(), all.end());
    return all;
}

double geometric_mean(const std::vector<double>& values)
{
    double sum = 0;
    for (const double value : values)
        sum += std::log(value);
    return values.empty() ? 0 : std::exp(sum / double(values.size()));
}

void add_distribution(std::ostringstream& text, const StrangersTable& table)
{
    text << "| threshold | frames | least | a tenth below | median | a tenth above | most | "
            "geometric mean | under 1 |\n|---|---|---|---|---|---|---|---|---|\n";
    for (const Setting& setting : antialias_settings()) {
        const std::vector<double> all = figures(table, setting, speed_up);
        if (all.empty())
            continue;
        const auto at = [&](double part) {
            return number(all[std::size_t(part * double(all.size() - 1) + 0.5)], "%.2f");
        };
        const auto slower = std::lower_bound(all.begin(), all.end(), 1.0) - all.begin();
        text << "| +A" << setting.name << " | " << all.size() << " | " << at(0) << " | " << at(0.1)
             << " | " << at(0.5) << " | " << at(0.9) << " | " << at(1) << " | **"
             << number(geometric_mean(all), "%.2f") << "** | " << slower << " |\n";
    }
}

/// Adds a table of geometric means and of minima (`least`) or maxima, by the kind of lighting.
void add_kinds(std::ostringstream& text, const StrangersTable& table, Figure figure, bool least)
{
    std::set<std::string> kinds;
    for (const auto& [key, panel] : table.panels())
        if (const std::string* kind = table.kind(key.first))
            kinds.insert(*kind);
    text << "Geometric means (in brackets: the " << (least ? "least" : "most")
         << ") by what the light needs:\n\n| kind |";
    for (const Setting& setting : antialias_settings())
        text << " +A" << setting.name << " |";
    text << "\n|---|---|---|---|---|---|\n";
    for (const std::string& kind : kinds) {
        text << "| " << kind << " |";
        for (const Setting& setting : antialias_settings()) {
            const std::vector<double> all = figures(table, setting, figure, kind);
            if (all.empty())
                text << " |";
            else
                text << ' ' << number(geometric_mean(all), "%.2f") << " ("
                     << number(least ? all.front() : all.back(), "%.2f") << ") |";
        }
        text << '\n';
    }
}

/// Adds how often the program's 95% interval contains the measured error.
void add_honesty(std::ostringstream& text, const StrangersTable& table)
{
    int held = 0, intervals = 0;
    for (const auto& [key, panel] : table.panels())
        for (const auto& [setting, row] : panel)
            if (row.estimate && row.error > row.floor) {
                ++intervals;
                held += row.estimate->low <= row.error && row.error <= row.estimate->high;
            }
    text << "The program's own interval holds the measured error in " << held << " of " << intervals
         << " frames (those that err more than the mean of the converged ones).\n";
}

void add_panels(std::ostringstream& text, const StrangersTable& table)
{
    text << "| scene | sheet | one ray: seconds, error |";
    for (const Setting& setting : antialias_settings())
        text << " +A" << setting.name << ": times (error) |";
    text << "\n|---|---|---|";
    for (std::size_t k = 0; k < antialias_settings().size(); ++k)
        text << "---|";
    text << '\n';
    for (const auto& [key, panel] : table.panels()) {
        text << "| " << key.first << " | " << key.second << " | ";
        const auto one = panel.find(brute_force_settings()[0].full_name());
        if (one != panel.end())
            text << number(one->second.cpu_seconds, "%.2f") << ", "
                 << number(one->second.error, "%.3f");
        text << " |";
        for (const Setting& setting : antialias_settings()) {
            const auto row = panel.find(setting.full_name());
            const auto value = speed_up(panel, setting);
            text << ' ' << (value ? number(*value, "%.2f") : "\u2013");
            if (row != panel.end())
                text << " (" << number(row->second.error, "%.4f") << ")";
            text << " |";
        }
        text << '\n';
    }
}

} // namespace

std::string strangers_page(const StrangersTable& table)
{
    std::ostringstream text;
    text
        << "# +A against brute force, on scenes of POV-Ray's\n\n"
           "Brute force's processor time, divided by +A's, at equal error of the frame: above 1, "
           "+A is\nthe faster. Where +A errs more than a single ray, that ray's time stands for "
           "brute force's.\n\n";
    add_distribution(text, table);
    text << '\n';
    add_kinds(text, table, speed_up, true);
    text << "\nThe processor time of +A, divided by that of +A without reconstruction, at equal "
            "error: below 1,\nit pays.\n";
    add_kinds(text, table, time_to_that_without, false);
    text << '\n';
    add_honesty(text, table);
    text << '\n';
    add_panels(text, table);
    text << "\nA dash: missing, or the other method has no frame with so small, or so large, an "
            "error, or\nthe error is smaller than that of the converged frames.\n\nLeft out:\n\n";
    for (const auto& [scene, reason] : table.left_out())
        text << "- " << scene << ": " << reason << '\n';
    return text.str();
}

void write_strangers_plot(const StrangersTable& table, const std::string& folder)
{
    Plot plot;
    plot.title = "+A against brute force at equal error, over POV-Ray's sample scenes";
    plot.x.label = "share of the scenes and sheets (%)";
    plot.y.label = "brute force's time by +A's";
    plot.y.logarithmic = true;
    for (const Setting& setting : antialias_settings()) {
        const std::vector<double> all = figures(table, setting, speed_up);
        PlotSeries series;
        series.label = "+A" + setting.name;
        for (std::size_t k = 0; k < all.size(); ++k) {
            series.x.push_back(100 * (double(k) + 0.5) / double(all.size()));
            series.y.push_back(all[k]);
        }
        if (!all.empty())
            plot.series.push_back(series);
    }
    if (plot.series.empty())
        return;
    for (const char* file : {"/strangers.svg", "/strangers.png"})
        write_file(folder + file, plot_bytes(plot, plot_format(file)));
}

} // namespace integral::bench
