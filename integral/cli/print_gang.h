// SPDX-License-Identifier: AGPL-3.0-or-later
// Puts the frames of `integral print` on one page.
#ifndef INTEGRAL_CLI_PRINT_GANG_H
#define INTEGRAL_CLI_PRINT_GANG_H

#include "integral/cli/print_options.h"

#include <memory>
#include <vector>

namespace integral {

using Readers = std::vector<std::unique_ptr<FrameReader>>;

/// Opens each FRAME. Throws UsageError, InputError.
Readers open_frames(const PrintOptions& o);

/// Arranges several frames on the paper of `settings` and turns the paper if only that gives room,
/// or room for more; prints a line about their lenses. Sets settings.page.frames, and `readers` to
/// a reader for each of them; opens more readers if copies do not stand level. `settings`: of the
/// first frame. Returns the geometry of all frames as one picture. Throws UsageError, InputError.
FrameMetadata arrange(const PrintOptions& o, Readers& frames, PrintSettings& settings,
                      std::vector<FrameReader*>& readers);

} // namespace integral

#endif
