// SPDX-License-Identifier: AGPL-3.0-or-later
#include "bench/strangers.h"

#include <algorithm>
#include <cmath>

namespace integral::bench {

namespace {

// A frame of one ray a pixel that errs by less than a quarter of a step of 8 bits shows nothing
// that could be anti-aliased.
constexpr double least_error_of_one_ray = 0.001;

Setting light_field(const std::string& threshold)
{
    return {threshold, "", {"+A" + threshold, "+R5", "+AM2"}};
}

/// The seconds in which the best of some settings reaches an error; nothing if all of them err
/// more, or all less. Between the settings that no other beats, log(time) is interpolated linearly
/// over log(error).
std::optional<double> seconds_of_best(const StrangersPanel& panel,
                                      const std::vector<Setting>& settings, double error)
{
    std::vector<StrangersRow> rows;
    for (const Setting& each : settings) {
        const auto measured = panel.find(each.full_name());
        if (measured != panel.end() && measured->second.error > 0)
            rows.push_back(measured->second);
    }
    std::stable_sort(rows.begin(), rows.end(), [](const StrangersRow& a, const StrangersRow& b) {
        return a.cpu_seconds < b.cpu_seconds;
    });
    const StrangersRow* last = nullptr; // the unbeaten one with the next greater error
    for (const StrangersRow& next : rows) {
        if (last && next.error >= last->error)
            continue;
        if (next.error <= error) {
            if (!last)
                return next.error == error ? std::optional<double>(next.cpu_seconds) : std::nullopt;
            const double along = std::log(last->error / error) / std::log(last->error / next.error);
            return last->cpu_seconds * std::pow(next.cpu_seconds / last->cpu_seconds, along);
        }
        last = &next;
    }
    return std::nullopt;
}

} // namespace

const std::vector<Setting>& brute_force_settings()
{
    static const auto both = [](int pixel, int beam) {
        const std::string p = std::to_string(pixel), b = std::to_string(beam);
        return Setting{p + "x" + b, "pixel_samples " + p + " beam_samples " + b, {}};
    };
    static const std::vector<Setting> settings = {
        {"auto", "lens_mapping auto", {}},
        {"2", "beam_samples 2", {}},
        {"4", "beam_samples 4", {}},
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
    if (found == panel.end() || one == panel.end() || one->second.error < least_error_of_one_ray ||
        found->second.error < found->second.floor)
        return std::nullopt;
    const StrangersRow& row = found->second;
    if (row.error >= one->second.error)
        return one->second.cpu_seconds / row.cpu_seconds;
    const auto seconds = seconds_of_best(panel, brute_force_settings(), row.error);
    if (!seconds)
        return std::nullopt;
    return *seconds / row.cpu_seconds;
}

std::optional<double> time_to_that_without(const StrangersPanel& panel, const Setting& setting)
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

} // namespace integral::bench
