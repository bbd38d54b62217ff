// SPDX-License-Identifier: AGPL-3.0-or-later
// The plots of `integral sheet --plot`.
#ifndef INTEGRAL_CLI_SHEET_PLOTS_H
#define INTEGRAL_CLI_SHEET_PLOTS_H

#include "integral/io/plot.h"
#include "integral/lightfield/sheet_report.h"

namespace integral {

/// spread: width of the capture aperture's micro-image against its distance, by three models
/// (thesis figure 3-26). lens: the beam of the full model against the extended pinhole's ray, from
/// a lens's axis to its margin. sheets: the same, in one figure, for each of the thesis's sheets.
/// resolution: against depth (figures 4-12, 4-15). film: what of its film a lens shows an eye at
/// the aperture's centre, with the film at its focus, nearer and farther (figures 4-3 to 4-6).
/// Throws UsageError for another kind, and where the sheet has no such figures.
Plot sheet_plot(const std::string& kind, const FrameMetadata& geometry, const Viewer& viewer);

} // namespace integral

#endif
