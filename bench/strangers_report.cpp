// SPDX-License-Identifier: AGPL-3.0-or-later
#include "bench/strangers.h"

#include "integral/base/file_bytes.h"
#include "integral/io/plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

namespace integral::bench {

namespace {

/// In the table, words about a scene stand in the place of a sheet and a setting: why it is left
/// out, and what kind it is of.
constexpr const char *left_out_mark = "left out", *kind_mark = "kind";

/// Without what would end a field or a line.
std::string plain(std::string text)
{
    for (char& c : text)
        if (c == ',' || c == '\n' || c == '\r' || c == '|')
            c = ' ';
    return text;
}

std::string number(double value, const char* format = "%.6g")
{
    char text[40];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

Setting light_field(const std::string& threshold)
{
    return {Family::light_field, threshold, "", {"+A" + threshold, "+R5", "+AM2"}};
}

/// speed_up or time_by_that_without.
using Figure = std::optional<double>(const StrangersPanel& panel, const Setting& setting);

/// A figure at one threshold over all scenes and sheets, in rising order; `kind`: over those of one
/// kind.
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

/// The seconds in which the best of some settings reaches an error; nothing if all of them err
/// more, or all less.
std::optional<double> seconds_of_best(const StrangersPanel& panel,
                                      const std::vector<Setting>& settings, double error)
{
    Panel rungs;
    Sampler families;
    for (const Setting& each : settings) {
        const auto measured = panel.find(each.full_name());
        if (measured == panel.end())
            continue;
        families.push_back(each.family);
        Measurement& rung = rungs.rungs.emplace_back();
        rung.setting = each;
        rung.own_error = measured->second.error;
        rung.cost.cpu_seconds = measured->second.cpu_seconds;
    }
    return seconds_at(rungs, families, error);
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

/// A table of geometric means, and of the least or the most, by what a scene's light needs.
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

/// How often the program's interval of 95% holds the error that was measured.
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

StrangersTable::StrangersTable(const std::string& file) : file_(file)
{
    if (!std::filesystem::exists(file)) {
        append("scene,sheet,setting,cpu_seconds,error,reference_error,estimate,low,high");
        return;
    }
    std::istringstream lines(read_file(file));
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line))
        read_line(line);
}

void StrangersTable::read_line(const std::string& line)
{
    std::vector<std::string> fields(1);
    for (const char c : line) {
        if (c == ',')
            fields.emplace_back();
        else
            fields.back() += c;
    }
    if (fields.size() == 3 && fields[1] == left_out_mark) {
        left_out_[fields[0]] = fields[2];
        return;
    }
    if (fields.size() == 3 && fields[1] == kind_mark) {
        kinds_[fields[0]] = fields[2];
        return;
    }
    try {
        const auto value = [&](std::size_t k) { return std::stod(fields.at(k)); };
        StrangersRow row{value(3), value(4), value(5), std::nullopt};
        if (!fields.at(6).empty()) {
            row.estimate.emplace();
            row.estimate->rms = value(6);
            row.estimate->low = value(7);
            row.estimate->high = value(8);
        }
        panels_[{fields[0], fields[1]}][fields[2]] = row;
    } catch (const std::logic_error&) {
        throw std::runtime_error(file_ + ": not a line of this program: " + line);
    }
}

void StrangersTable::append(const std::string& line) const
{
    std::ofstream to(file_, std::ios::app);
    to << line << '\n';
    if (!to.flush())
        throw OutputError(file_ + ": cannot be written");
}

const StrangersRow* StrangersTable::find(const Key& panel, const std::string& setting) const
{
    const auto rows = panels_.find(panel);
    if (rows == panels_.end())
        return nullptr;
    const auto row = rows->second.find(setting);
    return row == rows->second.end() ? nullptr : &row->second;
}

void StrangersTable::add(const Key& panel, const std::string& setting, const StrangersRow& row)
{
    std::string estimate = ",,";
    if (row.estimate)
        estimate = number(row.estimate->rms) + "," + number(row.estimate->low) + "," +
                   number(row.estimate->high);
    append(panel.first + "," + panel.second + "," + setting + "," + number(row.cpu_seconds) + "," +
           number(row.error) + "," + number(row.floor) + "," + estimate);
    panels_[panel][setting] = row;
}

const std::string* StrangersTable::reason(const std::string& scene) const
{
    const auto found = left_out_.find(scene);
    return found == left_out_.end() ? nullptr : &found->second;
}

const std::string* StrangersTable::kind(const std::string& scene) const
{
    const auto found = kinds_.find(scene);
    return found == kinds_.end() ? nullptr : &found->second;
}

void StrangersTable::set_kind(const std::string& scene, const std::string& kind)
{
    kinds_[scene] = plain(kind);
    append(scene + "," + kind_mark + "," + kinds_[scene]);
}

void StrangersTable::leave_out(const std::string& scene, const std::string& reason)
{
    std::string words = plain(reason);
    constexpr std::size_t most = 300;
    if (words.size() > most)
        words = "... " + words.substr(words.size() - most);
    append(scene + "," + left_out_mark + "," + words);
    left_out_[scene] = words;
}

const std::vector<Setting>& brute_force_settings()
{
    static const auto both = [](int pixel, int beam) {
        const std::string p = std::to_string(pixel), b = std::to_string(beam);
        return Setting{Family::both, p + "x" + b, "pixel_samples " + p + " beam_samples " + b, {}};
    };
    static const std::vector<Setting> settings = {
        {Family::one_ray, "auto", "lens_mapping auto", {}},
        {Family::beam, "2", "beam_samples 2", {}},
        {Family::beam, "4", "beam_samples 4", {}},
        both(2, 2),
        both(2, 4),
        both(4, 4),
        both(4, 8),
        both(8, 8),
        both(8, 16)};
    return settings;
}

const std::vector<Setting>& antialias_settings()
{
    static const std::vector<Setting> settings = {light_field("0.3"), light_field("0.1"),
                                                  light_field("0.05"), light_field("0.03"),
                                                  light_field("0.02")};
    return settings;
}

const std::vector<Setting>& settings_without_reconstruction()
{
    static const std::vector<Setting> settings = [] {
        std::vector<Setting> all;
        for (const char* threshold : {"0.5", "0.3", "0.1", "0.03", "0.01"}) {
            all.push_back(light_field(threshold));
            all.back().options.push_back("Integral_Reconstruction=off");
        }
        return all;
    }();
    return settings;
}

std::optional<double> speed_up(const StrangersPanel& panel, const Setting& setting)
{
    const auto found = panel.find(setting.full_name());
    const auto one = panel.find(brute_force_settings()[0].full_name());
    if (found == panel.end() || one == panel.end() || found->second.error < found->second.floor)
        return std::nullopt;
    const StrangersRow& row = found->second;
    if (row.error >= one->second.error)
        return one->second.cpu_seconds / row.cpu_seconds;
    const auto seconds = seconds_of_best(panel, brute_force_settings(), row.error);
    if (!seconds)
        return std::nullopt;
    return *seconds / row.cpu_seconds;
}

std::optional<double> time_by_that_without(const StrangersPanel& panel, const Setting& setting)
{
    const auto found = panel.find(setting.full_name());
    if (found == panel.end() || found->second.error < found->second.floor)
        return std::nullopt;
    const auto seconds = seconds_of_best(panel, settings_without_reconstruction(),
                                         found->second.error);
    if (!seconds)
        return std::nullopt;
    return found->second.cpu_seconds / *seconds;
}

std::string strangers_page(const StrangersTable& table)
{
    std::ostringstream text;
    text
        << "# +A against brute force, on scenes of POV-Ray's\n\n"
           "Brute force's processor time by +A's, at equal error of the frame: above 1, +A is the "
           "faster.\nWhere +A errs more than a single ray it is the single ray's time by +A's.\n\n";
    add_distribution(text, table);
    text << '\n';
    add_kinds(text, table, speed_up, true);
    text << "\nThe processor time of +A by that of +A without reconstruction, at equal error: below "
            "1, it pays.\n";
    add_kinds(text, table, time_by_that_without, false);
    text << '\n';
    add_honesty(text, table);
    text << '\n';
    add_panels(text, table);
    text << "\nA dash: missing, or one of the two errs less than the other or the converged ones "
            "can tell.\n\nLeft out:\n\n";
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
