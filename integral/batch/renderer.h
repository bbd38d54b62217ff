// SPDX-License-Identifier: AGPL-3.0-or-later
// Runs povray-integral and extracts the reason of a failure from its output.
#ifndef INTEGRAL_BATCH_RENDERER_H
#define INTEGRAL_BATCH_RENDERER_H

#include "integral/base/file_bytes.h"
#include "integral/base/parallel.h"
#include "integral/batch/child_process.h"

#include <string>
#include <vector>

namespace integral {

/// A new folder for temporary files (in TMPDIR or /tmp), deleted with its content at the end.
class ScratchFolder {
public:
    /// Throws OutputError.
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    std::string path(const std::string& name) const { return path_ + "/" + name; }

private:
    std::string path_;
};

/// povray-integral's path: next to this program, or else the bare name, for a search on PATH.
std::string renderer_program();

/// Replaces this program by povray-integral with these words on its command line. Throws InputError
/// if that cannot be run.
[[noreturn]] void become_renderer(const std::vector<std::string>& words);

/// The reason of a failure in POV-Ray's output: the sentence with "Error:", its broken lines
/// joined; else the last line.
std::string reason_in(const std::string& said);

/// The error to throw if povray-integral cannot be run. `said` is its output or ChildProcess's
/// message.
InputError no_renderer(const std::string& said);

/// The finished share of a frame, from the last progress line of the renderer's output in the file
/// `said`; 0 if there is none.
double rendered_part(const std::string& said);

/// The words of povray-integral's command line for a scene (names_scene): one picture of an
/// animation, no window; then `options`. povray-integral searches its library path for a scene that
/// is not at this path. Throws InputError for a pipe or device, which can be read only once, and
/// for a name that povray-integral cannot open.
std::vector<std::string> scene_words(const std::string& scene,
                                     const std::vector<std::string>& options = {});

/// Runs povray-integral (renderer_program) and waits for its end. Its output goes to a file in
/// `scratch`. Throws InputError with `what` (the scene's name) and the renderer's reason if it
/// fails, Interrupted if it is interrupted. `progress` counts hundredths of the pixels, as the
/// renderer prints them. Returns how it ended.
ChildEnd render(const std::string& what, const std::vector<std::string>& options,
                const ScratchFolder& scratch, const Progress& progress = {});

} // namespace integral

#endif
