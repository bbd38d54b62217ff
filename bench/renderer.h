// SPDX-License-Identifier: AGPL-3.0-or-later
// Runs the renderer as a subprocess for the benches, and defines their sheets and settings.
#ifndef BENCH_RENDERER_H
#define BENCH_RENDERER_H

#include <optional>
#include <string>
#include <vector>

namespace integral::bench {

struct Sheet {
    std::string name;        ///< the arrangement's word in scenes; also in file names
    std::string title;       ///< in plots
    double pitch, thickness; ///< mm
    double ior;
    std::string words() const; ///< the sheet in the scene language
};

/// Sampling of a frame.
struct Setting {
    std::string name;
    std::string words;                ///< for the integral camera in the scene
    std::vector<std::string> options; ///< for the renderer's command line
    std::string full_name() const;    ///< words and options
};

const std::vector<Sheet>& sheets();

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
    int patience = 0;          ///< seconds after which a render is ended; 0: never

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
std::string camera_words(const Sheet& sheet, const Setting& setting);

} // namespace integral::bench

#endif
