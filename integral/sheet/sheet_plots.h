// SPDX-License-Identifier: AGPL-3.0-or-later
// Plots a sheet's figures, for `integral sheet --plot`.
#ifndef INTEGRAL_SHEET_SHEET_PLOTS_H
#define INTEGRAL_SHEET_SHEET_PLOTS_H

#include "integral/io/plot.h"
#include "integral/sheet/sheet_report.h"

namespace integral {

/// The plot of one kind:
///   spread      width of the capture aperture's micro-image against the aperture's distance, by
///               three models (thesis figure 3-26)
///   lens        the beam of the full model against the extended pinhole's ray, from a lens's axis
///               to its margin
///   sheets      root mean square error of the extended pinhole's ray, for the thesis's sheets
///   resolution  against depth (figures 4-12, 4-15)
///   pixels-seen  number of a lens's pixels that an eye sees at once, by the eye's distance (figure
///               4-8)
///   pixel-spread width covered by a pixel, against distance (figure 4-11)
///   film        the part of the film that a lens shows to an eye at the aperture's centre, with
///               the film at the lens's focus, nearer and farther (figures 4-3 to 4-6)
/// Throws std::invalid_argument for another kind, and if the sheet has no such figures.
Plot sheet_plot(const std::string& kind, const FrameMetadata& geometry, const Viewer& viewer);

/// All kinds, for messages and completion: "spread, lens or film".
std::string sheet_plot_kinds();

} // namespace integral

#endif
