// SPDX-License-Identifier: AGPL-3.0-or-later
// povray-integral, run by a command of the integral program.
#ifndef INTEGRAL_BATCH_RENDERER_H
#define INTEGRAL_BATCH_RENDERER_H

#include "integral/base/file_bytes.h"

#include <string>
#include <vector>

namespace integral {

/// A folder of its own in the machine's place for temporary files, deleted with all that is in it
/// at the end.
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

/// POV-Ray's reason for a failure in all that it said: the sentence that says "Error:", its broken
/// lines joined, else its last line.
std::string reason_in(const std::string& said);

/// What to throw where povray-integral cannot be run, of what ChildProcess or it has said.
InputError no_renderer(const std::string& said);

/// Runs povray-integral, the one beside this program or else the first on PATH, and waits for its
/// end. What it says goes to a file in `scratch`. Throws InputError, with the renderer's own
/// reason, where it fails, naming `what` (the scene); Interrupted where that is why.
void render(const std::string& what, const std::vector<std::string>& options,
            const ScratchFolder& scratch);

} // namespace integral

#endif
