// SPDX-License-Identifier: AGPL-3.0-or-later
// Runs povray-integral and finds the reason in what it prints.
#ifndef INTEGRAL_BATCH_RENDERER_H
#define INTEGRAL_BATCH_RENDERER_H

#include "integral/base/file_bytes.h"
#include "integral/base/parallel.h"
#include "integral/batch/child_process.h"

#include <string>
#include <vector>

namespace integral {

/// A new folder for temporary files (in TMPDIR or /tmp), deleted with all that is in it at the end.
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

/// povray-integral's path: the one beside this program, or else its bare name, to be looked for on
/// PATH.
std::string renderer_program();

/// Has povray-integral take this program's place, with these words of its command line. Throws
/// InputError if it cannot be run.
[[noreturn]] void become_renderer(const std::vector<std::string>& words);

/// The reason for a failure in what POV-Ray has printed: the sentence with "Error:", its broken
/// lines joined; else the last line.
std::string reason_in(const std::string& said);

/// The error to throw if povray-integral cannot be run. `said` is what it or ChildProcess has
/// printed.
InputError no_renderer(const std::string& said);

/// The part of a frame that the renderer has done, by the last line of its progress in what it has
/// printed to the file `said`; 0 where there is none.
double rendered_part(const std::string& said);

/// The words of povray-integral's command line for a scene (names_scene): one picture of an
/// animation, no window. A scene that is not here is one that povray-integral looks for, as after
/// +I. Throws InputError for a pipe or a device, which can be read only once.
std::vector<std::string> scene_words(const std::string& scene);

/// Runs povray-integral, the one beside this program or else the first on PATH, and waits for its
/// end. What it prints goes to a file in `scratch`. If it fails, throws InputError with `what` (the
/// scene's name) and the renderer's reason; Interrupted if it was interrupted. `progress` counts
/// hundredths of the pixels, by what the renderer prints. Returns what it took.
ChildEnd render(const std::string& what, const std::vector<std::string>& options,
                const ScratchFolder& scratch, const Progress& progress = {});

} // namespace integral

#endif
