// SPDX-License-Identifier: AGPL-3.0-or-later
// The report of `integral sheet`: figures with their units and equation numbers.
#ifndef INTEGRAL_SHEET_SHEET_REPORT_H
#define INTEGRAL_SHEET_SHEET_REPORT_H

#include "integral/frame/frame_metadata.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace integral {

/// The viewer, at the aperture's distance. Lengths in mm.
struct Viewer {
    double pupil = 5;                 ///< diameter; > 0
    std::vector<double> depths;       ///< rows of the table of resolution; each > 0
    std::optional<double> macro_lens; ///< focal length of macro-lenses before the sheet; 0 to 300
    double detail = 5; ///< distance between edges for the forecast of sampling errors; > 0
    std::optional<double> ghost; ///< width of a flip's ghost at the viewer, on either side of a
                                 ///< change (ghost_in_zone)
};

/// The geometry along the direction in which lenses and pixels are counted, mm: x; but y for a
/// lenticular sheet whose cylinders lie across (lenses_lie_across).
struct LensRowGeometry {
    double period;   ///< from each lens to the next
    double cell;     ///< extent of a lens's cell, which an aperture fills (cell_extent)
    double pixel;    ///< pixel pitch
    double aperture; ///< the capture aperture's extent
    int pixels;      ///< of the film
};
LensRowGeometry counted(const FrameMetadata& geometry);

/// The depth budget (depth_budget) as the viewer sees it, mm: through a projection lens, the budget
/// of the sheet's image. Empty if the sheet has none.
std::optional<double> seen_budget(const FrameMetadata& geometry);

/// The report as text: tables of figures. Missing figures are "-".
std::string sheet_report_text(const FrameMetadata& geometry, const Viewer& viewer);

/// The geometry's document, as from to_json, plus `figures`, `depths` and `sampling`. Missing
/// figures are null.
nlohmann::ordered_json sheet_report_json(const FrameMetadata& geometry, const Viewer& viewer);

} // namespace integral

#endif
