// SPDX-License-Identifier: AGPL-3.0-or-later
// Puts the frames of `integral print` on one page.
#ifndef INTEGRAL_CLI_PRINT_GANG_H
#define INTEGRAL_CLI_PRINT_GANG_H

#include "integral/cli/print_options.h"

#include <memory>
#include <vector>

namespace integral {

using Readers = std::vector<std::unique_ptr<FrameReader>>;

/// Opens each FRAME, as often as --repeat requires; once if it requires as often as there is room.
/// Throws UsageError, InputError.
Readers open_frames(const PrintOptions& o);

/// Arranges several frames on the paper of `settings` and turns the paper if only that gives room;
/// prints a line about their lenses. Sets settings.page.frames and opens the frames that fill the
/// page. `settings`: of the first frame. Returns the geometry of all frames as one picture. Throws
/// UsageError, InputError.
FrameMetadata arrange(const PrintOptions& o, Readers& frames, PrintSettings& settings);

} // namespace integral

#endif
