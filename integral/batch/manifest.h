// SPDX-License-Identifier: AGPL-3.0-or-later
// The content of a batch's manifest. doc/commands/batch.md describes the fields for users.
#ifndef INTEGRAL_BATCH_MANIFEST_H
#define INTEGRAL_BATCH_MANIFEST_H

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace integral {

using Names = std::vector<std::string>;
using Indices = std::vector<int>; ///< positions in one of a manifest's lists

constexpr std::size_t most_jobs = 10000;   ///< before "exclude" removes any
constexpr std::size_t most_steps = 100000; ///< of all those jobs; a step is a BatchStep (plan.h)

/// The manifest's papers, panels and previews to make; empty: all.
struct Targets {
    std::optional<Indices> papers, panels, previews;
};

struct FrameSize {
    int width = 0, height = 0; ///< pixels; 0: by the renderer's own settings
};

struct BatchScene {
    std::string name, file; ///< .pov or .ini
    Names options;          ///< of the renderer
    std::vector<std::pair<std::string, std::string>> declare;
    FrameSize size;
    Names inputs;                  ///< files that the scene reads and its text does not name
    std::optional<Indices> sheets; ///< not given: all; an empty list: the scene's own camera
    Targets targets;
};

struct BatchSheet {
    std::string name, camera; ///< words of Integral_Camera
    Names options;
    FrameSize size; ///< replaces the scene's
    Targets targets;
};

/// A paper, a panel or a preview: the output of one command from a frame.
struct BatchTarget {
    std::string name, format; ///< the output's extension
    std::string what; ///< a paper's name or size, or empty; a panel's name or file; empty for a
                      ///< preview
    Names options;    ///< of the command: integral print, lcd or replay
    // Positions of `what` and `options`, for messages: "batch.json:7: papers[0].paper".
    std::string place, options_place;
};

/// A scene behind a sheet, with the targets to make from its frame.
struct BatchJob {
    std::string name;
    int scene = 0, sheet = -1; ///< indices in the manifest's lists; -1: none
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

/// Reads and checks a manifest: fields, names, the readability of scenes and panels, options that
/// only the batch may set, the limits above on jobs and steps. Takes time in proportion to the
/// document and the steps. Throws InputError with line and field.
Manifest read_manifest(const std::string& path);

/// A name in the manifest as a path: relative names start at `folder`.
std::string path_in(const std::string& folder, const std::string& name);

} // namespace integral

#endif
