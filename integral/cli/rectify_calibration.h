// SPDX-License-Identifier: AGPL-3.0-or-later
// `integral rectify --calibration`: measures a lens sheet by a photograph of a calibration page.
#ifndef INTEGRAL_CLI_RECTIFY_CALIBRATION_H
#define INTEGRAL_CLI_RECTIFY_CALIBRATION_H

#include "integral/cli/geometry_options.h"

namespace integral {

struct CalibrationOptions {
    std::string photo;
    std::optional<std::string> output, start, page, distance;
    SheetOptions sheet;
    FilmOptions film;
    bool json = false;
    int threads = 0;
};

/// Prints the figures, and writes the measured sheet to -o's FILE.json. Returns an ExitStatus;
/// throws as a Command's `run` does.
int read_calibration(const CalibrationOptions& o);

} // namespace integral

#endif
