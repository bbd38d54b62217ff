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
    std::string name;             ///< in file names, and of its lenses in the scene language
    std::string title;            ///< in plots
    double pitch, thickness, ior; ///< mm
    std::string words(int finer = 1) const; ///< of the scene language, of lenses so many times
                                            ///< finer
};

/// Settings of one kind are one series of the plots.
enum class Family { one_ray, beam, pixel, both, light_field, antialias, model };
constexpr Family families[] = {Family::one_ray,     Family::beam,      Family::pixel, Family::both,
                               Family::light_field, Family::antialias, Family::model};
const char* title_of(Family);

/// One rung: how a frame is sampled.
struct Setting {
    Family family;
    std::string name;                 ///< beside its point in the plots
    std::string words;                ///< of the integral camera
    std::vector<std::string> options; ///< of the renderer
    std::string full_name() const;    ///< as a user would write it
};

const std::vector<std::string>& scene_names(); ///< files bench/scenes/NAME.pov
const std::vector<Sheet>& sheets();
enum class Extent {
    all,
    samplers, ///< those that compare anti-aliasing with brute force, in the reference's lens model
              ///< and mapping
    light_field, ///< the same without POV-Ray's own anti-aliasing
    quick
};
/// The first is the plainest: one ray a pixel, mapping auto. The others' run times are multiples of
/// its.
std::vector<Setting> ladder(Extent extent);
/// The setting of the reference frame for errors, which uses another seed than the other settings.
Setting reference_setting(Extent extent);

// ---- the renderer (error_against_time_renderer.cpp) ----

struct RenderCost {
    double seconds = 0;     ///< of tracing, by the clock
    double cpu_seconds = 0; ///< of the processor, without parsing: tracing and radiosity's pretrace
    long long camera_rays = 0; ///< that left the sheet
    long long rays = 0;        ///< and all that these gave rise to but those to lights
};

/// The program under measurement.
struct Renderer {
    std::string program;       ///< povray-integral
    std::string scene_folder;  ///< bench/scenes
    std::string work_folder;   ///< where frames and logs are written; must exist
    int width = 0, height = 0; ///< pixels of the frames
    int finer = 1; ///< so many times finer than 300 dpi are these, and finer than their own the
                   ///< sheets; not the perspective pictures
    int patience = 0; ///< seconds after which a render is ended; 0: never

    /// Renders WORK/NAME.png on one thread, 16 bits a sample. Without `camera` it is the scene's
    /// perspective picture, `times` as wide and high. Throws std::runtime_error with the program's
    /// last words where it fails.
    RenderCost render(const std::string& scene, const std::string& name,
                      const std::optional<std::string>& camera,
                      const std::vector<std::string>& options, int times = 1) const;
    std::string picture(const std::string& name) const { return work_folder + "/" + name + ".png"; }
};

constexpr double dots_per_inch = 300;
/// Words of a whole integral camera.
std::string camera_words(const Sheet& sheet, const Setting& setting, int finer = 1);

// ---- measurements (error_against_time_measure.cpp) ----

/// 3 x 3 over the aperture; behind cylinders, which show nothing new along themselves, 9 in a row
/// across it.
constexpr int eyes_across = 3;

struct Measurement {
    Setting setting;
    RenderCost cost; ///< the least seconds of all runs
    int runs = 0;
    double times = 0;           ///< cpu_seconds / those of the plainest setting
    double rmse = 0, psnr = 0;  ///< of the frame against the reference
    ViewFigures to_reference;   ///< of the view from the aperture's centre, against the reference
                                ///< frame's view
    ViewFigures from_side;      ///< the same from near the aperture's right edge
    ViewFigures to_perspective; ///< of the view from the centre, against the scene's perspective
                                ///< picture from there
    std::vector<ViewFigures> from_eyes; ///< of the view from each of the panel's eyes, against the
                                        ///< perspective picture from there
    double own_error = 0; ///< RMSE over the pixels that this setting lights, freed of the
                          ///< reference's own error
    std::optional<ErrorEstimate> estimate; ///< the program's, of own_error
    bool on_front_of_seconds = false, on_front_of_rays = false;
};

/// All of one scene behind one sheet.
struct Panel {
    std::string scene;
    Sheet sheet;
    int width = 0, height = 0; ///< pixels
    std::vector<EyePosition> eyes;
    Measurement reference; ///< its estimate is its own error; its figures against itself are 0
    std::vector<Measurement> rungs;
    std::string name() const { return scene + "-" + sheet.name; }
    double pixels() const { return double(width) * height; }
};

/// Renders and measures. `say` is told what is done, a line at a time.
Panel measure(const Renderer& renderer, const std::string& scene, const Sheet& sheet, Extent extent,
              const std::function<void(const std::string&)>& say);

/// The Pareto front of several settings: those for which no other setting has both at most the same
/// cost and at most the same error. Costs within 5% and errors within 1% count as equal; of equal
/// settings the first is on the front.
std::vector<bool> pareto_front(const std::vector<double>& costs, const std::vector<double>& errors);

/// A way to sample: the families of settings of which a user would take the best.
using Sampler = std::vector<Family>;
const Sampler& brute_force(); ///< so many samples for every pixel
const Sampler& by_pixels();   ///< POV-Ray's own anti-aliasing

/// The CPU seconds at which the sampler's front has that own_error: log(time) between its settings,
/// over log(error). Nothing where its settings do not reach that error, or all err less. Only
/// settings of mapping auto count.
std::optional<double> seconds_at(const Panel& panel, const Sampler& sampler, double error);

/// How often the program's interval contains own_error, among the settings with the reference's
/// lens model.
struct Honesty {
    int held = 0, intervals = 0;
};
bool judged_by_reference_model(const Setting& setting);
bool holds(const Measurement& measurement);
Honesty honesty(const std::vector<Panel>& panels);

// ---- the report (error_against_time_report.cpp, _plots.cpp) ----

std::string csv(const std::vector<Panel>& panels);
std::string fronts_table(const std::vector<Panel>& panels); ///< Markdown
/// Each anti-aliased setting's time beside that of brute force and of POV-Ray's anti-aliasing at
/// the same error; Markdown.
std::string speedups(const Panel& panel);
std::string speedups_summary(const std::vector<Panel>& panels); ///< each panel's best
std::string eyes_table(const std::vector<Panel>& panels);       ///< CSV: every view from every eye
/// FOLDER/SCENE-SHEET-FIGURE-against-COST.svg and .png, and FOLDER/fronts-against-COST and
/// FOLDER/estimate.
void write_plots(const std::vector<Panel>& panels, const std::string& folder);

} // namespace integral::bench

#endif
