// SPDX-License-Identifier: AGPL-3.0-or-later
// The steps of a batch: what is run, of what, and what comes of it.
#ifndef INTEGRAL_BATCH_PLAN_H
#define INTEGRAL_BATCH_PLAN_H

#include "integral/batch/manifest.h"
#include "integral/batch/strips.h"

#include <map>
#include <string>
#include <vector>

namespace integral {

enum class StepKind { frame, print, panel, preview, thumbnail };
const char* name_of(StepKind kind);

/// One child process: povray-integral for a frame, the integral program for the others.
struct BatchStep {
    StepKind kind = StepKind::frame;
    std::string name;   ///< of the step, unique: frame.JOB, print.JOB.TARGET
    int job = 0;        ///< in the manifest's list
    int frame = -1;     ///< the step that makes the frame which this one takes; -1: this is one
    std::string target; ///< the paper's, panel's or preview's name
    std::string output; ///< path below the output folder: frames/JOB.png
    std::string folder; ///< in which it runs
    Names words;        ///< of its command line, without output and threads
    FrameSize size;     ///< of a frame, where the manifest says it
    int threads = 0;    ///< that the manifest gives it; 0: as the batch finds best
    std::optional<RowStrip> rows; ///< of a frame, where these alone are made: a strip
    Names files;                  ///< of the manifest that it reads, beside the frame: paths
};

struct BatchPlan {
    std::vector<BatchStep> steps; ///< each after that which it needs; a job's together
};

BatchPlan plan_of(const Manifest& manifest);

/// The placeholder for the frame among a step's words.
extern const char* const frame_word;

/// What programs the steps run with: part of what decides whether a step is done.
struct BatchPrograms {
    std::string renderer_version, integral_version; ///< in their own words
    std::string renderer_share;                     ///< the renderer's folder of include files
};

/// Hashes of what steps take, each file read once in a run of the program.
class StepInputs {
public:
    StepInputs(const Manifest& manifest, BatchPrograms programs);

    /// The hash of all that a step's output depends on: words, program, contents of files; of a
    /// step that takes a frame, that frame's content, `frame_hash`. Throws InputError where a file
    /// cannot be read.
    std::string hash(const BatchStep& step, const std::string& frame_hash);

private:
    const std::string& content(const std::string& path);
    const std::string& scene_hash(const BatchStep& step);

    const Manifest& manifest_;
    BatchPrograms programs_;
    std::map<std::string, std::string> contents_,
        scenes_; ///< hashes by path, and by scene and options
};

} // namespace integral

#endif
