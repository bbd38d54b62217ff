// SPDX-License-Identifier: AGPL-3.0-or-later
// What was measured as a table for programs and one for readers.
#include "bench/error_against_time.h"

#include "integral/lightfield/names.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace integral::bench {

namespace {

std::string number(double value, int digits = 6)
{
    if (!std::isfinite(value))
        return "";
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

std::string quoted(const std::string& text) { return '"' + text + '"'; }

void add_estimate(std::ostringstream& row, const std::optional<ErrorEstimate>& estimate)
{
    if (estimate)
        row << number(estimate->rms) << ',' << number(estimate->low) << ',' << number(estimate->high) << ','
            << name_of(estimate->method) << ',' << estimate->pixels;
    else
        row << ",,,,";
}

void add_cost(std::ostringstream& row, const Measurement& m)
{
    row << m.runs << ',' << number(m.cost.seconds) << ',' << number(m.cost.cpu_seconds) << ',' << number(m.times) << ','
        << m.cost.camera_rays << ',' << m.cost.rays << ',';
}

void add_row(std::ostringstream& row, const Panel& panel, const Measurement& m)
{
    row << panel.scene << ',' << panel.sheet.name << ',' << quoted(m.setting.full_name()) << ','
        << quoted(title_of(m.setting.family)) << ',';
    add_cost(row, m);
    row << number(m.rmse) << ',' << number(m.psnr) << ',' << number(m.to_reference.psnr) << ',' << number(m.to_reference.ssim)
        << ',' << number(m.from_side.psnr) << ',' << number(m.from_side.ssim) << ',' << number(m.to_perspective.psnr)
        << ',' << number(m.to_perspective.ssim) << ',' << number(m.own_error) << ',';
    add_estimate(row, m.estimate);
    row << ',' << (m.on_front_of_seconds ? 1 : 0) << ',' << (m.on_front_of_rays ? 1 : 0) << '\n';
}

/// The reference has no error against itself: what is empty does not apply.
void add_reference(std::ostringstream& row, const Panel& panel)
{
    const Measurement& m = panel.reference;
    row << panel.scene << ',' << panel.sheet.name << ',' << quoted(m.setting.full_name()) << ",reference,";
    add_cost(row, m);
    row << ",,,,,," << number(m.to_perspective.psnr) << ',' << number(m.to_perspective.ssim) << ",,";
    add_estimate(row, m.estimate);
    row << ",,\n";
}

} // namespace

std::string csv(const std::vector<Panel>& panels)
{
    std::ostringstream text;
    text << "scene,sheet,setting,family,runs,seconds,cpu_seconds,times_one_ray,camera_rays,rays,rmse,psnr_db,"
            "view_psnr_db,view_ssim,side_view_psnr_db,side_view_ssim,view_perspective_psnr_db,view_perspective_ssim,"
            "own_error,estimate,estimate_low,estimate_high,estimate_method,estimate_pixels,front_of_seconds,front_of_rays\n";
    for (const Panel& panel : panels) {
        add_reference(text, panel);
        for (const Measurement& rung : panel.rungs)
            add_row(text, panel, rung);
    }
    return text.str();
}

std::string fronts_table(const std::vector<Panel>& panels)
{
    std::ostringstream text;
    for (const Panel& panel : panels) {
        text << "### " << panel.scene << ", " << panel.sheet.title << "\n\n"
             << "| setting | seconds | times one ray | rays a pixel | RMSE | PSNR dB | view PSNR dB | view SSIM | "
                "view to perspective dB |\n"
             << "|---|---|---|---|---|---|---|---|---|\n";
        std::vector<const Measurement*> front;
        for (const Measurement& rung : panel.rungs)
            if (rung.on_front_of_seconds)
                front.push_back(&rung);
        std::stable_sort(front.begin(), front.end(),
                         [](const Measurement* a, const Measurement* b) { return a->cost.cpu_seconds < b->cost.cpu_seconds; });
        const auto row = [&](const Measurement& m, const std::string& errors) {
            char line[300];
            std::snprintf(line, sizeof line, "| `%s` | %.3f | %.2f | %.1f | %s | %.1f |\n", m.setting.full_name().c_str(),
                          m.cost.cpu_seconds, m.times, double(m.cost.camera_rays) / panel.pixels(), errors.c_str(),
                          m.to_perspective.psnr);
            text << line;
        };
        for (const Measurement* m : front) {
            char errors[120];
            std::snprintf(errors, sizeof errors, "%.4f | %.1f | %.1f | %.4f", m->rmse, m->psnr, m->to_reference.psnr,
                          m->to_reference.ssim);
            row(*m, errors);
        }
        char own[80];
        std::snprintf(own, sizeof own, "(its own: %.4f) | %.1f | |", panel.reference.estimate->rms,
                      -20 * std::log10(panel.reference.estimate->rms));
        row(panel.reference, own);
        text << '\n';
    }
    return text.str();
}

} // namespace integral::bench
