// SPDX-License-Identifier: AGPL-3.0-or-later
// The parts of bench/error_against_time: the list of settings, the renderer as a subprocess, the
// measurements, and the report.
#ifndef BENCH_ERROR_AGAINST_TIME_H
#define BENCH_ERROR_AGAINST_TIME_H

#include "bench/views.h"

#include "integral/lightfield/frame.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace integral::bench {

// ---- the ladder (error_against_time_ladder.cpp) ----

struct Sheet {
    std::string name;        ///< the arrangement's word in scenes; also in file names
    std::string title;       ///< in plots
    double pitch, thickness; ///< mm
    double ior;
    /// The sheet in the scene language, with pitch and thickness divided by `finer`.
    std::string words(int finer = 1) const;
};

/// Settings of one kind are one series of the plots.
enum class Family { one_ray, beam, pixel, both, light_field, antialias, model };
constexpr Family families[] = {Family::one_ray,     Family::beam,      Family::pixel, Family::both,
                               Family::light_field, Family::antialias, Family::model};
const char* title_of(Family);

/// One rung: how a frame is sampled.
struct Setting {
    Family family;
    std::string name;                 ///< label of its point in the plots
    std::string words;                ///< for the integral camera in the scene
    std::vector<std::string> options; ///< for the renderer's command line
    std::string full_name() const;    ///< words and options
};

const std::vector<std::string>& scene_names(); ///< files bench/scenes/NAME.pov
const std::vector<Sheet>& sheets();
enum class Extent {
    all,
    samplers,    ///< those that compare anti-aliasing with brute force; lens model and mapping are
                 ///< the reference's
    light_field, ///< as samplers, but without POV-Ray's own anti-aliasing
    quick
};
/// The first setting is the plainest: one ray a pixel, mapping auto. Run times of the others are
/// given as multiples of its run time.
std::vector<Setting> ladder(Extent extent);
/// The setting of the reference frame, from which errors are measured. Its random seed differs from
/// that of the other settings.
Setting reference_setting(Extent extent);

// ---- the renderer (error_against_time_renderer.cpp) ----

struct RenderCost {
    double seconds = 0;        ///< of tracing, by the clock
    double cpu_seconds = 0;    ///< of tracing and radiosity's pretrace; parsing is not included
    long long camera_rays = 0; ///< that left the sheet
    long long rays = 0;        ///< camera, reflected and refracted rays; no shadow rays
};

/// The program under measurement.
struct Renderer {
    std::string program;       ///< povray-integral
    std::string scene_folder;  ///< bench/scenes
    std::string work_folder;   ///< where frames and logs are written; must exist
    int width = 0, height = 0; ///< pixels of the frames
    int finer = 1; ///< the film has `finer` times 300 dpi, and sheets have pitch and thickness
                   ///< divided by `finer`; perspective pictures are not affected
    int patience = 0; ///< seconds after which a render is ended; 0: never

    /// Renders WORK/NAME.png on one thread, 16 bits a sample. Without `camera` it renders the
    /// scene's perspective picture, `times` as wide and high. Throws std::runtime_error with the
    /// last lines of the program's output if the program fails.
    RenderCost render(const std::string& scene, const std::string& name,
                      const std::optional<std::string>& camera,
                      const std::vector<std::string>& options, int times = 1) const;
    std::string picture(const std::string& name) const { return work_folder + "/" + name + ".png"; }
};

constexpr double dots_per_inch = 300;
/// The statements of a whole integral camera: sheet, film and the setting's words.
std::string camera_words(const Sheet& sheet, const Setting& setting, int finer = 1);

// ---- measurements (error_against_time_measure.cpp) ----

/// Views are taken from 3 x 3 eyes in the aperture; for a lenticular sheet, which shows no vertical
/// parallax, from 9 eyes in a row.
constexpr int eyes_across = 3;

struct Measurement {
    Setting setting;
    RenderCost cost; ///< the least seconds of all runs
    int runs = 0;
    double times = 0;           ///< cpu_seconds, divided by those of the plainest setting
    double rmse = 0, psnr = 0;  ///< of the frame, compared with the reference
    ViewFigures to_reference;   ///< of the view from the aperture's centre, compared with the
                                ///< reference frame's view
    ViewFigures from_side;      ///< the same from near the aperture's right edge
    ViewFigures to_perspective; ///< of the view from the centre, compared with the scene's
                                ///< perspective picture from there
    std::vector<ViewFigures> from_eyes; ///< of the view from each of the panel's eyes, compared
                                        ///< with the perspective picture from there
    double own_error = 0; ///< RMSE over the pixels that this setting lights; the reference's own
                          ///< error is subtracted (as squares)
    std::optional<ErrorEstimate> estimate; ///< the program's estimate of own_error
    bool on_front_of_seconds = false, on_front_of_rays = false;
};

/// All measurements of one scene behind one sheet.
struct Panel {
    std::string scene;
    Sheet sheet;
    int width = 0, height = 0; ///< pixels
    std::vector<EyePosition> eyes;
    Measurement reference; ///< figures that compare it with itself stay 0
    std::vector<Measurement> rungs;
    std::string name() const { return scene + "-" + sheet.name; }
    double pixels() const { return double(width) * height; }
};

/// Renders and measures. Calls `say` with lines of progress.
Panel measure(const Renderer& renderer, const std::string& scene, const Sheet& sheet, Extent extent,
              const std::function<void(const std::string&)>& say);

/// The Pareto front of several settings: those for which no other setting has both at most the same
/// cost and at most the same error. Costs within 5% and errors within 1% count as equal; of equal
/// settings the first is on the front.
std::vector<bool> pareto_front(const std::vector<double>& costs, const std::vector<double>& errors);

/// A way to sample: families of settings, of which a user would take the best.
using Sampler = std::vector<Family>;
const Sampler& brute_force(); ///< the same number of samples for every pixel
const Sampler& by_pixels();   ///< POV-Ray's own anti-aliasing

/// The CPU seconds that the sampler needs for an own_error of `error`. Between the settings of its
/// Pareto front, log(time) is interpolated linearly over log(error). Nothing if all its settings
/// have greater errors, or all have smaller ones. Only settings with mapping auto count.
std::optional<double> seconds_at(const Panel& panel, const Sampler& sampler, double error);

/// How often the program's interval of 95% contains own_error, among the settings with the
/// reference's lens model.
struct Honesty {
    int held = 0, intervals = 0;
};
bool judged_by_reference_model(const Setting& setting);
bool holds(const Measurement& measurement);
Honesty honesty(const std::vector<Panel>& panels);

// ---- the report (error_against_time_report.cpp, _plots.cpp) ----

std::string csv(const std::vector<Panel>& panels);
std::string fronts_table(const std::vector<Panel>& panels); ///< Markdown
/// Compares the time of each setting that is anti-aliased in the light field with the times that
/// brute force and POV-Ray's anti-aliasing need for the same error; Markdown.
std::string speedups(const Panel& panel);
std::string speedups_summary(const std::vector<Panel>& panels); ///< the best of each panel
std::string eyes_table(const std::vector<Panel>& panels);       ///< CSV: every view from every eye
/// Writes FOLDER/SCENE-SHEET-FIGURE-against-COST, FOLDER/fronts-against-COST and FOLDER/estimate,
/// each as .svg and .png.
void write_plots(const std::vector<Panel>& panels, const std::string& folder);

} // namespace integral::bench

#endif
