// SPDX-License-Identifier: AGPL-3.0-or-later
#include "bench/error_against_time.h"

#include "integral/compare/compare.h"
#include "integral/io/image_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace integral::bench {

namespace {

// The eye of the view from the side is this fraction of the aperture's width right of its centre.
constexpr double side = 0.45;
constexpr double short_run = 0.3; // seconds: a shorter run is repeated within its round
constexpr double long_run = 1;    // seconds: a longer run is made once only
constexpr int rounds = 2, most_repeats = 3;

Frame view_of(const Frame& frame, const EyePosition& eye)
{
    return bench::view_of(frame, eye, usual_form);
}

EyePosition eye_at_side(const Frame& frame) { return {side * frame.metadata->aperture.width, 0}; }

/// Renders the settings of one panel, and compares them with the reference frame and the
/// perspective pictures.
class Bench {
public:
    Bench(const Renderer& renderer, const std::string& scene, const Sheet& sheet)
        : renderer_(renderer), scene_(scene), sheet_(sheet), name_(scene + "-" + sheet.name)
    {
    }

    void make_wanted(Panel& panel);
    void time(Measurement& measurement) const;
    void judge(Measurement& measurement) const;

private:
    RenderCost render(const Setting& setting, const std::string& name, bool audit) const
    {
        std::vector<std::string> options = setting.options;
        options.push_back(audit ? "Integral_Audit=on" : "Integral_Audit=off");
        return renderer_.render(scene_, name, camera_words(sheet_, setting, renderer_.finer),
                                options);
    }

    const Renderer& renderer_;
    std::string scene_;
    Sheet sheet_;
    std::string name_;
    Frame perspective(const std::string& name, const std::optional<EyePosition>& eye) const
    {
        return perspective_of(renderer_, scene_, name, eye, {}, perspective_times, usual_form);
    }
    std::vector<ViewFigures> figures_from_eyes(const Frame& frame) const;

    Frame reference_, reference_view_, reference_side_view_, perspective_;
    std::vector<EyePosition> eyes_;
    std::vector<Frame> perspectives_; ///< from each of eyes_
};

std::vector<ViewFigures> Bench::figures_from_eyes(const Frame& frame) const
{
    std::vector<ViewFigures> result;
    for (std::size_t k = 0; k < eyes_.size(); ++k)
        result.push_back(view_figures(view_of(frame, eyes_[k]), perspectives_[k]));
    return result;
}

void Bench::make_wanted(Panel& panel)
{
    Measurement& reference = panel.reference;
    const std::string frame = name_ + "-reference", picture = name_ + "-perspective";
    reference.cost = render(reference.setting, frame, true);
    reference.runs = 1;
    reference_ = read_frame_with_metadata(renderer_.picture(frame));
    reference.estimate = reference_.metadata->render->error;
    if (!reference.estimate || reference.estimate->method != ErrorMethod::split_halves)
        throw std::runtime_error(renderer_.picture(frame) +
                                 ": the metadata have no error estimate from split halves");
    reference_view_ = view_of(reference_, {});
    reference_side_view_ = view_of(reference_, eye_at_side(reference_));

    perspective_ = perspective(picture, std::nullopt);
    reference.to_perspective = view_figures(reference_view_, perspective_);
    panel.eyes = eyes_ = eyes_of(reference_, eyes_across);
    for (std::size_t k = 0; k < eyes_.size(); ++k)
        perspectives_.push_back(perspective(picture + "-" + std::to_string(k + 1), eyes_[k]));
    reference.from_eyes = figures_from_eyes(reference_);
}

/// Makes one round of timing, and keeps the least seconds of all rounds.
void Bench::time(Measurement& measurement) const
{
    if (measurement.runs > 0 && measurement.cost.cpu_seconds > long_run)
        return;
    double spent = 0;
    for (int repeat = 0; repeat < most_repeats && (repeat == 0 || spent < short_run); ++repeat) {
        const RenderCost cost = render(measurement.setting, name_ + "-timed", false);
        const RenderCost least = measurement.cost;
        spent += cost.cpu_seconds;
        measurement.cost = cost;
        if (measurement.runs++ > 0) {
            measurement.cost.seconds = std::min(cost.seconds, least.seconds);
            measurement.cost.cpu_seconds = std::min(cost.cpu_seconds, least.cpu_seconds);
        }
    }
}

void Bench::judge(Measurement& measurement) const
{
    render(measurement.setting, name_ + "-rung", true);
    const Frame frame = read_frame_with_metadata(renderer_.picture(name_ + "-rung"));
    const Comparison comparison = compare(frame, reference_);
    measurement.rmse = comparison.rmse;
    measurement.psnr = comparison.psnr;
    const Frame view = view_of(frame, {});
    measurement.to_reference = view_figures(view, reference_view_);
    measurement.from_side = view_figures(view_of(frame, eye_at_side(frame)), reference_side_view_);
    measurement.to_perspective = view_figures(view, perspective_);
    measurement.from_eyes = figures_from_eyes(frame);
    measurement.estimate = frame.metadata->render->error;
    const double measured = lit_rmse(frame, reference_),
                 floor = reference_.metadata->render->error->rms;
    measurement.own_error = std::sqrt(std::max(0.0, measured * measured - floor * floor));
}

void mark_fronts(Panel& panel)
{
    std::vector<double> seconds, rays, errors;
    for (const Measurement& rung : panel.rungs) {
        seconds.push_back(rung.cost.cpu_seconds);
        rays.push_back(double(rung.cost.camera_rays));
        errors.push_back(rung.rmse);
    }
    const auto front_of_seconds = pareto_front(seconds, errors),
               front_of_rays = pareto_front(rays, errors);
    for (std::size_t i = 0; i < panel.rungs.size(); ++i) {
        panel.rungs[i].on_front_of_seconds = front_of_seconds[i];
        panel.rungs[i].on_front_of_rays = front_of_rays[i];
    }
}

} // namespace

std::vector<bool> pareto_front(const std::vector<double>& costs, const std::vector<double>& errors)
{
    constexpr double same_cost = 1.05, same_error = 1.01;
    std::vector<bool> front(costs.size(), true);
    for (std::size_t i = 0; i < costs.size(); ++i)
        for (std::size_t other = 0; other < costs.size() && front[i]; ++other) {
            const bool no_worse = costs[other] <= same_cost * costs[i] &&
                                  errors[other] <= same_error * errors[i];
            const bool better = same_cost * costs[other] < costs[i] ||
                                same_error * errors[other] < errors[i];
            front[i] = !(no_worse && (better || other < i));
        }
    return front;
}

Panel measure(const Renderer& renderer, const std::string& scene, const Sheet& sheet, Extent extent,
              const std::function<void(const std::string&)>& say)
{
    Panel panel{scene, sheet, renderer.width, renderer.height, {}, {}, {}};
    Bench bench(renderer, scene, sheet);
    panel.reference.setting = reference_setting(extent);
    bench.make_wanted(panel);
    say(panel.name() + ": reference of " + panel.reference.setting.words + " in " +
        std::to_string(panel.reference.cost.cpu_seconds) + " CPU seconds, its own error " +
        std::to_string(panel.reference.estimate->rms));
    for (const Setting& setting : ladder(extent))
        panel.rungs.emplace_back().setting = setting;
    for (int round = 0; round < rounds; ++round)
        for (Measurement& rung : panel.rungs)
            bench.time(rung);
    const double plainest = panel.rungs.front().cost.cpu_seconds;
    panel.reference.times = panel.reference.cost.cpu_seconds / plainest;
    for (Measurement& rung : panel.rungs) {
        bench.judge(rung);
        rung.times = rung.cost.cpu_seconds / plainest;
        char line[200];
        std::snprintf(line, sizeof line,
                      "  %-40s %8.3f s %7.2f x   RMSE %.4f   view %.1f dB   estimate %.4f",
                      rung.setting.full_name().c_str(), rung.cost.cpu_seconds, rung.times,
                      rung.rmse, rung.to_reference.psnr, rung.estimate ? rung.estimate->rms : 0.0);
        say(line);
    }
    mark_fronts(panel);
    return panel;
}

const Sampler& brute_force()
{
    static const Sampler families = {Family::one_ray, Family::beam, Family::pixel, Family::both};
    return families;
}

const Sampler& by_pixels()
{
    static const Sampler families = {Family::antialias};
    return families;
}

std::optional<double> seconds_at(const Panel& panel, const Sampler& sampler, double error)
{
    std::vector<const Measurement*> all;
    for (const Measurement& rung : panel.rungs) {
        const Family family = rung.setting.family;
        const bool counts = family != Family::one_ray || &rung == &panel.rungs.front();
        if (counts && std::count(sampler.begin(), sampler.end(), family) > 0 && rung.own_error > 0)
            all.push_back(&rung);
    }
    std::stable_sort(all.begin(), all.end(), [](const Measurement* a, const Measurement* b) {
        return a->cost.cpu_seconds < b->cost.cpu_seconds;
    });
    const Measurement* last = nullptr; // the setting of the front with the next greater error
    for (const Measurement* next : all) {
        if (last && next->own_error >= last->own_error)
            continue;
        if (next->own_error <= error) {
            if (!last)
                return next->own_error == error ? std::optional<double>(next->cost.cpu_seconds)
                                                : std::nullopt;
            const double along = std::log(last->own_error / error) /
                                 std::log(last->own_error / next->own_error);
            return last->cost.cpu_seconds *
                   std::pow(next->cost.cpu_seconds / last->cost.cpu_seconds, along);
        }
        last = next;
    }
    return std::nullopt;
}

bool judged_by_reference_model(const Setting& setting) { return setting.family != Family::model; }

bool holds(const Measurement& measurement)
{
    return measurement.estimate->low <= measurement.own_error &&
           measurement.own_error <= measurement.estimate->high;
}

Honesty honesty(const std::vector<Panel>& panels)
{
    Honesty result;
    for (const Panel& panel : panels)
        for (const Measurement& rung : panel.rungs)
            if (rung.estimate && judged_by_reference_model(rung.setting)) {
                ++result.intervals;
                result.held += holds(rung);
            }
    return result;
}

} // namespace integral::bench
