// SPDX-License-Identifier: AGPL-3.0-or-later
#include "bench/error_against_time.h"

#include "integral/io/plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>

namespace integral::bench {

namespace {

constexpr int grey = 6; // index in the plots' palette

std::string text_of(const char* format, double value)
{
    char text[60];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

/// A figure of merit and how it is drawn.
struct Figure {
    const char* file;
    const char* title;
    const char* label;
    bool logarithmic;
    double (*value)(const Measurement&);
    bool more_is_better;
    bool of_perspective; ///< compares with the perspective picture, so the reference has a value
};

const Figure figures[] = {
    {"rmse", "Error of the frame", "RMSE of the frame (1 = full scale)", true,
     [](const Measurement& m) { return m.rmse; }, false, false},
    {"psnr", "Error of the frame", "PSNR of the frame (dB)", false,
     [](const Measurement& m) { return m.psnr; }, true, false},
    {"view-psnr", "The replayed view against the reference's", "PSNR of the view (dB)", false,
     [](const Measurement& m) { return m.to_reference.psnr; }, true, false},
    {"view-ssim", "The replayed view against the reference's", "1 \u2212 SSIM of the view", true,
     [](const Measurement& m) { return 1 - m.to_reference.ssim; }, false, false},
    {"side-view-psnr", "The view from the aperture's edge against the reference's",
     "PSNR of the view (dB)", false, [](const Measurement& m) { return m.from_side.psnr; }, true,
     false},
    {"side-view-ssim", "The view from the aperture's edge against the reference's",
     "1 \u2212 SSIM of the view", true, [](const Measurement& m) { return 1 - m.from_side.ssim; },
     false, false},
    {"view-perspective-psnr", "The replayed view against the perspective picture",
     "PSNR of the view (dB)", false, [](const Measurement& m) { return m.to_perspective.psnr; },
     true, true},
    {"eyes-perspective-psnr", "The views from nine eyes against the perspective pictures",
     "mean PSNR of the views (dB)", false,
     [](const Measurement& m) { return mean(m.from_eyes).psnr; }, true, true},
    {"eyes-perspective-ssim", "The views from nine eyes against the perspective pictures",
     "1 \u2212 mean SSIM of the views", true,
     [](const Measurement& m) { return 1 - mean(m.from_eyes).ssim; }, false, true},
    {"view-perspective-ssim", "The replayed view against the perspective picture",
     "1 \u2212 SSIM of the view", true,
     [](const Measurement& m) { return 1 - m.to_perspective.ssim; }, false, true},
};

struct Cost {
    const char* file;
    const char* title;
    const char* label;
    double (*value)(const Panel&, const Measurement&);
};

const Cost costs[] = {
    {"seconds", "run time",
     "run time, in run times of the plainest setting (lens_mapping auto, one ray a pixel)",
     [](const Panel&, const Measurement& m) { return m.times; }},
    {"rays", "rays", "camera rays for each pixel of the frame",
     [](const Panel& panel, const Measurement& m) {
         return double(m.cost.camera_rays) / panel.pixels();
     }},
};

std::string about(const Panel& panel)
{
    return panel.scene + ".pov, " + panel.sheet.title + ", " + std::to_string(panel.width) + " x " +
           std::to_string(panel.height) +
           " pixels; plainest setting: " + text_of("%.3f", panel.rungs.front().cost.cpu_seconds) +
           " CPU seconds; the reference's own RMSE: " +
           text_of("%.4f", panel.reference.estimate->rms);
}

/// Points of a series that lie on each other get one label with all names, at the first of them.
void merge_names(PlotSeries& series, bool logarithmic)
{
    for (std::size_t i = 0; i < series.x.size(); ++i)
        for (std::size_t j = i + 1; j < series.x.size(); ++j) {
            const double apart = logarithmic ? std::fabs(series.y[i] / series.y[j] - 1) / 0.02
                                             : std::fabs(series.y[i] - series.y[j]) / 0.1;
            if (series.names[i].empty() || series.names[j].empty() || apart > 1 ||
                std::fabs(series.x[i] / series.x[j] - 1) > 0.2)
                continue;
            series.names[i] += ", " + series.names[j];
            series.names[j].clear();
        }
}

PlotSeries front_of(const Panel& panel, const Figure& figure, const Cost& cost)
{
    std::vector<double> x, errors;
    for (const Measurement& rung : panel.rungs) {
        x.push_back(cost.value(panel, rung));
        const double value = figure.value(rung);
        errors.push_back(figure.more_is_better ? std::pow(10.0, -value / 20) : value);
    }
    const std::vector<bool> front = pareto_front(x, errors);
    std::vector<std::size_t> order(x.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return x[a] < x[b]; });
    PlotSeries series;
    series.label = "Pareto front";
    series.style = PlotSeries::Style::dashed;
    series.colour = grey;
    for (const std::size_t i : order)
        if (front[i]) {
            series.x.push_back(x[i]);
            series.y.push_back(figure.value(panel.rungs[i]));
        }
    return series;
}

Plot plot_of(const Panel& panel, const Figure& figure, const Cost& cost)
{
    Plot plot;
    plot.title = std::string(figure.title) + ", by " + cost.title;
    plot.subtitle = about(panel);
    plot.width = 1000;
    plot.height = 640;
    plot.x = {cost.label, true, {}, {}};
    plot.y = {figure.label, figure.logarithmic, {}, {}};
    for (const Family family : families) {
        PlotSeries series;
        series.label = title_of(family);
        series.style = family == Family::beam || family == Family::pixel || family == Family::both
                           ? PlotSeries::Style::line_and_points
                           : PlotSeries::Style::points;
        for (const Measurement& rung : panel.rungs)
            if (rung.setting.family == family) {
                series.x.push_back(cost.value(panel, rung));
                series.y.push_back(figure.value(rung));
                series.names.push_back(rung.setting.name);
            }
        merge_names(series, figure.logarithmic);
        plot.series.push_back(series);
    }
    plot.series.push_back(front_of(panel, figure, cost));
    if (figure.of_perspective) {
        PlotSeries series;
        series.label = "the reference's view";
        series.colour = grey;
        for (const Measurement& rung : panel.rungs)
            series.x.push_back(cost.value(panel, rung));
        std::sort(series.x.begin(), series.x.end());
        series.y.assign(series.x.size(), figure.value(panel.reference));
        plot.series.push_back(series);
    }
    return plot;
}

/// The Pareto fronts of RMSE of all panels.
Plot fronts(const std::vector<Panel>& panels, const Cost& cost)
{
    Plot plot;
    plot.title = std::string("Least error of the frame, by ") + cost.title;
    plot.subtitle = "Pareto fronts of all settings, for each scene and sheet";
    plot.width = 1000;
    plot.height = 640;
    plot.x = {cost.label, true, {}, {}};
    plot.y = {figures[0].label, true, {}, {}};
    for (const Panel& panel : panels) {
        PlotSeries series = front_of(panel, figures[0], cost);
        series.label = panel.scene + ", " + panel.sheet.title;
        series.style = PlotSeries::Style::line_and_points;
        series.colour.reset();
        plot.series.push_back(series);
    }
    return plot;
}

/// The program's own error estimates, each divided by the measured error.
Plot estimates(const std::vector<Panel>& panels)
{
    const Honesty counts = honesty(panels);
    Plot plot;
    plot.title = "The program's own error estimate beside the measured error";
    plot.subtitle = std::to_string(counts.held) + " of " + std::to_string(counts.intervals) +
                    " intervals of 95% contain the measured error; other lens models are compared "
                    "with converged frames of the same lens model";
    plot.width = 1000;
    plot.height = 640;
    plot.x = {"measured RMSE over the lit pixels", true, {}, {}};
    plot.y = {"estimate / measured RMSE", true, {}, {}};
    PlotSeries audit, halves, model, exact;
    audit.label = "audit";
    halves.label = "split halves (pixel_samples and beam_samples)";
    model.label = "audit, other lens_model";
    exact.label = "exact";
    for (const Panel& panel : panels)
        for (const Measurement& rung : panel.rungs) {
            if (!rung.estimate || !(rung.own_error > 0))
                continue;
            PlotSeries& series = !judged_by_reference_model(rung.setting)      ? model
                                 : rung.estimate->method == ErrorMethod::audit ? audit
                                                                               : halves;
            series.x.push_back(rung.own_error);
            series.y.push_back(rung.estimate->rms / rung.own_error);
            series.low.push_back(rung.estimate->low / rung.own_error);
            series.high.push_back(rung.estimate->high / rung.own_error);
            exact.x.push_back(rung.own_error);
        }
    for (PlotSeries* series : {&audit, &halves, &model}) {
        series->style = PlotSeries::Style::points;
        plot.series.push_back(*series);
    }
    std::sort(exact.x.begin(), exact.x.end());
    exact.y.assign(exact.x.size(), 1);
    exact.style = PlotSeries::Style::dashed;
    exact.colour = grey;
    plot.series.push_back(exact);
    return plot;
}

void write_both(const Plot& plot, const std::string& name)
{
    write_plot(plot, name + ".svg");
    write_plot(plot, name + ".png");
}

} // namespace

void write_plots(const std::vector<Panel>& panels, const std::string& folder)
{
    for (const Cost& cost : costs) {
        for (const Panel& panel : panels)
            for (const Figure& figure : figures)
                write_both(plot_of(panel, figure, cost), folder + "/" + panel.name() + "-" +
                                                             figure.file + "-against-" + cost.file);
        write_both(fronts(panels, cost), folder + "/fronts-against-" + cost.file);
    }
    write_both(estimates(panels), folder + "/estimate");
}

} // namespace integral::bench
