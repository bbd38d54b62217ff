// SPDX-License-Identifier: AGPL-3.0-or-later
// The steps of a batch: the programs that it runs, what each reads and what it makes.
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

/// One run of a program: of povray-integral for a frame, of the integral program for the others.
struct BatchStep {
    StepKind kind = StepKind::frame;
    std::string name; ///< unique: frame.JOB, print.JOB.TARGET
    int job = 0;      ///< in the manifest's list
    int frame = -1;   ///< the step that makes the frame which this one reads; -1: a frame's own
    int target = -1;  ///< the paper, panel or preview, in the manifest's list; -1: none of these
    std::string target_name;      ///< of the paper, panel or preview; "eye" of a thumbnail
    std::string output;           ///< path below the output folder: frames/JOB.png
    std::string folder;           ///< in which the program runs
    Names words;                  ///< of the command line, without output and threads
    FrameSize size;               ///< of a frame, if the manifest gives it
    int threads = 0;              ///< that the manifest gives; 0: the batch chooses
    std::optional<RowStrip> rows; ///< of a strip: the rows of the frame that it makes
    Names files; ///< paths of further files that it reads, as the manifest names them
};

struct BatchPlan {
    std::vector<BatchStep> steps; ///< job after job; each job's frame first
    std::vector<int> frames;      ///< of each job the step that makes its frame
};

/// All steps of a manifest's jobs, at most most_steps.
BatchPlan plan_of(const Manifest& manifest);

/// Stands for the frame's path among a step's words.
extern const char* const frame_word;

/// The programs that the steps run. Another version makes every step anew.
struct BatchPrograms {
    std::string renderer_version, integral_version; ///< as they print them
    std::string renderer_share;                     ///< the renderer's folder of include files
};

/// Hashes of what steps read. Each file is read once, when it is first needed.
class StepInputs {
public:
    StepInputs(const Manifest& manifest, BatchPrograms programs);

    /// The hash of all that a step's output depends on: words, program, contents of files. If the
    /// step reads a frame, `frame_hash` is the hash of that frame's content. Throws InputError if a
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
