// SPDX-License-Identifier: AGPL-3.0-or-later
// The report of `integral sheet`: figures with their units and equation numbers.
#ifndef INTEGRAL_LIGHTFIELD_SHEET_REPORT_H
#define INTEGRAL_LIGHTFIELD_SHEET_REPORT_H

#include "integral/lightfield/frame_metadata.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace integral {

/// Who looks, from the aperture's distance. mm.
struct Viewer {
    double pupil = 5;           ///< diameter; > 0
    std::vector<double> depths; ///< at which to tabulate resolution; each > 0
    double detail = 5; ///< between the edges of the picture that sampling is judged by; > 0
};

/// The direction in which the lenses are counted: across the axes of a lenticular sheet along its
/// slit, along the rows of the others. mm.
struct Counted {
    double period;   ///< from lens to lens
    double cell;     ///< extent of a lens's cell, which an aperture fills (cell_extent)
    double pixel;    ///< pixel pitch
    double aperture; ///< the capture aperture's extent
    int pixels;      ///< of the film
};
Counted counted(const FrameMetadata& geometry);

/// A readable table. Figures that the geometry does not have are shown as "-".
std::string sheet_report_text(const FrameMetadata& geometry, const Viewer& viewer);

/// The geometry document (as to_json) with `figures`, `depths` and `sampling` added; absent figures
/// are null.
nlohmann::ordered_json sheet_report_json(const FrameMetadata& geometry, const Viewer& viewer);

} // namespace integral

#endif
