// SPDX-License-Identifier: AGPL-3.0-or-later
// What a batch's manifest asks for. doc/commands/batch.md says what each field means to its
// user.
#ifndef INTEGRAL_BATCH_MANIFEST_H
#define INTEGRAL_BATCH_MANIFEST_H

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace integral {

using Names = std::vector<std::string>;
using Indices = std::vector<int>; ///< in one of a manifest's lists

constexpr std::size_t most_jobs = 10000;   ///< before any are excluded
constexpr std::size_t most_steps = 100000; ///< of all those jobs: plan.h says what a step is

/// Which of the manifest's papers, panels and previews are made; not given: all.
struct Targets {
    std::optional<Indices> papers, panels, previews;
};

struct FrameSize {
    int width = 0, height = 0; ///< pixels; 0: the renderer's own settings say it
};

struct BatchScene {
    std::string name, file; ///< .pov or .ini
    Names options;          ///< the renderer's
    std::vector<std::pair<std::string, std::string>> declare;
    FrameSize size;
    Names inputs;                  ///< files that it reads and that its text does not name
    std::optional<Indices> sheets; ///< not given: all; empty: its own camera is integral
    Targets targets;
};

struct BatchSheet {
    std::string name, camera; ///< Integral_Camera's words
    Names options;
    FrameSize size; ///< instead of the scene's
    Targets targets;
};

/// A paper, a panel or a preview: what one command makes of a frame.
struct BatchTarget {
    std::string name, format; ///< the output's extension
    std::string what; ///< a paper's name or size, or empty; a panel's name or file; of a preview
                      ///< nothing
    Names options;    ///< of the command: integral print, lcd or replay
    // Where `what` and `options` stand, for messages: "batch.json:7: papers[0].paper".
    std::string place, options_place;
};

/// A scene behind a sheet, and what is made of its frame.
struct BatchJob {
    std::string name;
    int scene = 0, sheet = -1; ///< in the manifest's lists; -1: none
    Indices papers, panels, previews;
};

struct Manifest {
    std::string path, folder; ///< of the manifest; relative names in it start at the folder
    std::string output;       ///< folder
    std::string frame_format = "png";
    int frame_bits = 0; ///< 0: the renderer's
    std::vector<BatchScene> scenes;
    std::vector<BatchSheet> sheets;
    std::vector<BatchTarget> papers, panels, previews;
    std::vector<BatchJob> jobs; ///< all, in order; names are unique
};

/// Reads and checks a manifest: fields, names, that scenes and panels can be read, that no option
/// is given that the batch itself gives, that there are no more jobs and steps than the limits
/// above. Takes time in proportion to the document and the steps. Throws InputError with line and
/// field.
Manifest read_manifest(const std::string& path);

/// A name of the manifest as a path: absolute as it is, else from its folder.
std::string path_in(const std::string& folder, const std::string& name);

} // namespace integral

#endif
