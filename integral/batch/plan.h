// SPDX-License-Identifier: AGPL-3.0-or-later
// The steps of a batch: its program runs, with their inputs and outputs.
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

/// One program run: of povray-integral for a frame, of the integral program for other steps.
struct BatchStep {
    StepKind kind = StepKind::frame;
    std::string name; ///< unique: frame.JOB, print.JOB.TARGET
    int job = 0;      ///< index in the manifest's list
    int frame = -1;   ///< the step that makes this step's input frame; -1 in a frame's own step
    int target = -1;  ///< index of the paper, panel or preview in the manifest's list; -1: none
    std::string target_name;      ///< of the paper, panel or preview; "eye" of a thumbnail
    std::string output;           ///< path below the output folder: frames/JOB.png
    std::string folder;           ///< working folder of the program
    Names words;                  ///< of the command line, without output and threads
    FrameSize size;               ///< of a frame, if the manifest gives it
    int threads = 0;              ///< from the manifest; 0: chosen by the batch
    std::optional<RowStrip> rows; ///< for a strip: its rows of the frame
    Names files;                  ///< paths of further input files, as named in the manifest
};

struct BatchPlan {
    std::vector<BatchStep> steps; ///< job after job; each job's frame first
    std::vector<int> frames;      ///< for each job, the step that makes its frame
};

/// All steps of a manifest's jobs, at most most_steps.
BatchPlan plan_of(const Manifest& manifest);

/// Placeholder for the frame's path among a step's words.
extern const char* const frame_word;

/// Versions of the steps' programs. A new version makes the steps of that program anew.
struct BatchPrograms {
    std::string renderer_version, integral_version; ///< as they print them
    std::string renderer_share;                     ///< the renderer's folder of include files
};

/// Hashes the inputs of steps. Reads each file once, when it is first needed.
class StepInputs {
public:
    StepInputs(const Manifest& manifest, BatchPrograms programs);

    /// The hash of everything that determines a step's output: words, program, contents of files.
    /// `frame_hash` is the content hash of the frame that the step reads. Throws InputError if a
    /// file cannot be read.
    std::string hash(const BatchStep& step, const std::string& frame_hash);

private:
    const std::string& content(const std::string& path);
    const std::string& scene_hash(const BatchStep& step);

    const Manifest& manifest_;
    BatchPrograms programs_;
    std::map<std::string, std::string> contents_; ///< hashes of files by path
    std::map<std::string, std::string> scenes_;   ///< hashes of scenes by folder, file and words
};

} // namespace integral

#endif
