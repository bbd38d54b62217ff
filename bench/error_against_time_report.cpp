// SPDX-License-Identifier: AGPL-3.0-or-later
// The measurements as CSV tables for programs and as Markdown tables for readers.
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

void add_eyes(std::ostringstream& row, const Measurement& m)
{
    const ViewFigures middle = mean(m.from_eyes), worst = least(m.from_eyes);
    row << number(middle.psnr) << ',' << number(worst.psnr) << ',' << number(middle.ssim) << ','
        << number(worst.ssim) << ',';
}

void add_estimate(std::ostringstream& row, const std::optional<ErrorEstimate>& estimate)
{
    if (estimate)
        row << number(estimate->rms) << ',' << number(estimate->low) << ','
            << number(estimate->high) << ',' << name_of(estimate->method) << ','
            << estimate->pixels;
    else
        row << ",,,,";
}

void add_cost(std::ostringstream& row, const Measurement& m)
{
    row << m.runs << ',' << number(m.cost.seconds) << ',' << number(m.cost.cpu_seconds) << ','
        << number(m.times) << ',' << m.cost.camera_rays << ',' << m.cost.rays << ',';
}

void add_row(std::ostringstream& row, const Panel& panel, const Measurement& m)
{
    row << panel.scene << ',' << panel.sheet.name << ',' << quoted(m.setting.full_name()) << ','
        << quoted(title_of(m.setting.family)) << ',';
    add_cost(row, m);
    row << number(m.rmse) << ',' << number(m.psnr) << ',' << number(m.to_reference.psnr) << ','
        << number(m.to_reference.ssim) << ',' << number(m.from_side.psnr) << ','
        << number(m.from_side.ssim) << ',' << number(m.to_perspective.psnr) << ','
        << number(m.to_perspective.ssim) << ',';
    add_eyes(row, m);
    row << number(m.own_error) << ',';
    add_estimate(row, m.estimate);
    row << ',' << (m.on_front_of_seconds ? 1 : 0) << ',' << (m.on_front_of_rays ? 1 : 0) << '\n';
}

/// The reference is not compared with itself: those columns stay empty.
void add_reference(std::ostringstream& row, const Panel& panel)
{
    const Measurement& m = panel.reference;
    row << panel.scene << ',' << panel.sheet.name << ',' << quoted(m.setting.full_name())
        << ",reference,";
    add_cost(row, m);
    row << ",,,,,," << number(m.to_perspective.psnr) << ',' << number(m.to_perspective.ssim) << ',';
    add_eyes(row, m);
    row << ',';
    add_estimate(row, m.estimate);
    row << ",,\n";
}

/// The quotient seconds / by as text; a dash if there is no number.
std::string ratio(const std::optional<double>& seconds, double by)
{
    return seconds ? number(*seconds / by, 3) : "\u2013";
}

bool anti_aliased(const Measurement& m)
{
    return m.setting.family == Family::light_field || m.setting.family == Family::antialias;
}

/// The setting of a family that saves most time compared with a sampler.
struct Best {
    const Measurement* of = nullptr;
    double times = 0; ///< the sampler's time, divided by the setting's time
};

Best best_of(const Panel& panel, Family family, const Sampler& against)
{
    Best best;
    for (const Measurement& rung : panel.rungs) {
        if (rung.setting.family != family)
            continue;
        const auto seconds = seconds_at(panel, against, rung.own_error);
        if (seconds && *seconds / rung.cost.cpu_seconds > best.times)
            best = {&rung, *seconds / rung.cost.cpu_seconds};
    }
    return best;
}

std::string told(const Best& best)
{
    if (!best.of)
        return "\u2013";
    char text[200];
    std::snprintf(text, sizeof text, "%.2f (`%s`, %.4f)", best.times,
                  best.of->setting.full_name().c_str(), best.of->own_error);
    return text;
}

} // namespace

std::string speedups(const Panel& panel)
{
    std::ostringstream text;
    text << "### " << panel.scene << ", " << panel.sheet.title << "\n\n"
         << "| setting | seconds | RMSE of the lit pixels | brute force's time there | POV-Ray's "
            "+A's time there |\n"
            "|---|---|---|---|---|\n";
    for (const Measurement& rung : panel.rungs) {
        if (!anti_aliased(rung))
            continue;
        const double seconds = rung.cost.cpu_seconds;
        char line[300];
        std::snprintf(line, sizeof line, "| `%s` | %.3f | %.4f | ",
                      rung.setting.full_name().c_str(), seconds, rung.own_error);
        text << line << ratio(seconds_at(panel, brute_force(), rung.own_error), seconds) << " | "
             << (rung.setting.family == Family::light_field
                     ? ratio(seconds_at(panel, by_pixels(), rung.own_error), seconds)
                     : "")
             << " |\n";
    }
    text << "\nTimes are multiples of the setting's own time: above 1, the setting is faster. A "
            "dash: the settings compared with all have greater errors, or all have smaller "
            "ones.\n\n";
    return text.str();
}

std::string speedups_summary(const std::vector<Panel>& panels)
{
    std::ostringstream text;
    text << "### The most that +A in the light field saves\n\n"
         << "| scene, sheet | brute force's time by its (setting, RMSE) | POV-Ray's +A's time by "
            "its | brute force's by "
            "POV-Ray's +A's |\n|---|---|---|---|\n";
    for (const Panel& panel : panels)
        text << "| " << panel.scene << ", " << panel.sheet.name << " | "
             << told(best_of(panel, Family::light_field, brute_force())) << " | "
             << told(best_of(panel, Family::light_field, by_pixels())) << " | "
             << told(best_of(panel, Family::antialias, brute_force())) << " |\n";
    return text.str();
}

std::string eyes_table(const std::vector<Panel>& panels)
{
    std::ostringstream text;
    text << "scene,sheet,setting,eye_x_mm,eye_y_mm,psnr_db,ssim\n";
    const auto rows = [&](const Panel& panel, const Measurement& m) {
        for (std::size_t k = 0; k < m.from_eyes.size(); ++k)
            text << panel.scene << ',' << panel.sheet.name << ',' << quoted(m.setting.full_name())
                 << ',' << number(panel.eyes[k].x) << ',' << number(panel.eyes[k].y) << ','
                 << number(m.from_eyes[k].psnr) << ',' << number(m.from_eyes[k].ssim) << '\n';
    };
    for (const Panel& panel : panels) {
        rows(panel, panel.reference);
        for (const Measurement& rung : panel.rungs)
            rows(panel, rung);
    }
    return text.str();
}

std::string csv(const std::vector<Panel>& panels)
{
    std::ostringstream text;
    text << "scene,sheet,setting,family,runs,seconds,cpu_seconds,times_one_ray,camera_rays,rays,"
            "rmse,psnr_db,"
            "view_psnr_db,view_ssim,side_view_psnr_db,side_view_ssim,view_perspective_psnr_db,view_"
            "perspective_ssim,"
            "eyes_mean_psnr_db,eyes_least_psnr_db,eyes_mean_ssim,eyes_least_ssim,"
            "own_error,estimate,estimate_low,estimate_high,estimate_method,estimate_pixels,front_"
            "of_seconds,front_of_rays\n";
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
             << "| setting | seconds | times one ray | rays a pixel | RMSE | PSNR dB | view PSNR "
                "dB | view SSIM | "
                "view to perspective dB |\n"
             << "|---|---|---|---|---|---|---|---|---|\n";
        std::vector<const Measurement*> front;
        for (const Measurement& rung : panel.rungs)
            if (rung.on_front_of_seconds)
                front.push_back(&rung);
        std::stable_sort(front.begin(), front.end(),
                         [](const Measurement* a, const Measurement* b) {
                             return a->cost.cpu_seconds < b->cost.cpu_seconds;
                         });
        const auto row = [&](const Measurement& m, const std::string& errors) {
            char line[300];
            std::snprintf(line, sizeof line, "| `%s` | %.3f | %.2f | %.1f | %s | %.1f |\n",
                          m.setting.full_name().c_str(), m.cost.cpu_seconds, m.times,
                          double(m.cost.camera_rays) / panel.pixels(), errors.c_str(),
                          m.to_perspective.psnr);
            text << line;
        };
        for (const Measurement* m : front) {
            char errors[120];
            std::snprintf(errors, sizeof errors, "%.4f | %.1f | %.1f | %.4f", m->rmse, m->psnr,
                          m->to_reference.psnr, m->to_reference.ssim);
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
