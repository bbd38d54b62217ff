// SPDX-License-Identifier: AGPL-3.0-or-later
// Interface of an input of the studio: a scene, or pictures with depth.
#ifndef INTEGRAL_STUDIO_STUDIO_INPUT_H
#define INTEGRAL_STUDIO_STUDIO_INPUT_H

#include "integral/base/parallel.h"
#include "integral/studio/placement_settings.h"
#include "integral/studio/probe.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace integral {

/// Recipe of a picture: the command line of a program or, if that is empty, a function.
struct Making {
    std::vector<std::string> command;
    std::function<void(const Progress&)> function; ///< throws Interrupted where Progress stops it
};

/// A file that has been written, and the command that makes the print with it.
struct SavedPlacement {
    std::string file, command;
};

/// `frame` is frame_of_settings with the placement in the input. Files are named in the working
/// folder. All functions may be called by any thread, but those that are not const by one at a time.
class StudioInput {
public:
    virtual ~StudioInput() = default;

    /// The name without folder and extension.
    virtual std::string name() const = 0;
    /// The page's noun for it, and its unit of length.
    virtual const char* kind() const = 0;
    virtual const char* unit() const = 0;
    /// Width / height of the whole picture.
    virtual double aspect() const = 0;
    /// The files that it consists of. Throws InputError if they cannot be listed.
    virtual std::vector<std::string> files() const = 0;
    /// Forgets what has been read from the files.
    virtual void forget() {}

    /// Makes a probe's pictures. `scratch`: for files; must outlive the making.
    virtual Making probe(const ProbeRequest& request, const ScratchFolder& scratch) = 0;
    /// The probe that has been made. Throws InputError.
    virtual Probe made_probe(const ProbeRequest& request, const ScratchFolder& scratch) = 0;

    /// Makes the print as `file` (.png); or a draft of it, with pixels as wide as `draft` of the
    /// print's. Throws std::invalid_argument if the settings cannot work.
    virtual Making print(const PlacementSettings& settings, const FrameMetadata& frame,
                         std::optional<int> draft, const std::string& file) = 0;

    /// The page's words for settings. Throws std::invalid_argument likewise.
    virtual std::string words(const PlacementSettings& settings,
                              const FrameMetadata& frame) const = 0;
    /// Writes the file from which a command makes the print `file` (.png). Throws OutputError, and
    /// std::invalid_argument likewise.
    virtual SavedPlacement save(const PlacementSettings& settings, const FrameMetadata& frame,
                                const std::string& file) const = 0;
};

} // namespace integral

#endif
