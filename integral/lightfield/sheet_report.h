// SPDX-License-Identifier: AGPL-3.0-or-later
// The report of `integral sheet`: figures with their units and equation numbers.
#ifndef INTEGRAL_LIGHTFIELD_SHEET_REPORT_H
#define INTEGRAL_LIGHTFIELD_SHEET_REPORT_H

#include "integral/lightfield/frame_metadata.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace integral {

/// The viewer, whose distance is the aperture's. mm.
struct Viewer {
    double pupil = 5;                 ///< diameter; > 0
    std::vector<double> depths;       ///< at which to tabulate resolution; each > 0
    std::optional<double> macro_lens; ///< focal length of macro-lenses before the sheet; 0 to 300
    double detail = 5; ///< distance between the edges for which sampling errors are foretold; > 0
};

/// The geometry along one direction, in which lenses and pixels are counted: the slit's direction
/// of a lenticular sheet, the rows' direction of the others. mm.
struct Counted {
    double period;   ///< from each lens to the next
    double cell;     ///< extent of a lens's cell, which an aperture fills (cell_extent)
    double pixel;    ///< pixel pitch
    double aperture; ///< the capture aperture's extent
    int pixels;      ///< of the film
};
Counted counted(const FrameMetadata& geometry);

/// The depth budget (depth_budget) as the viewer sees it, mm: through a projection lens, that of
/// the sheet's image. Nothing if the sheet has none.
std::optional<double> seen_budget(const FrameMetadata& geometry);

/// The report for people: tables of figures. Those that the geometry does not have are "-".
std::string sheet_report_text(const FrameMetadata& geometry, const Viewer& viewer);

/// The geometry's document, as of to_json, with `figures`, `depths` and `sampling` added. Figures
/// that the geometry does not have are null.
nlohmann::ordered_json sheet_report_json(const FrameMetadata& geometry, const Viewer& viewer);

} // namespace integral

#endif
