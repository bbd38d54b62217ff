// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes a pitch chart's page for one sheet and printer: its scale, the chart, and the command to
// read it.
#ifndef INTEGRAL_PRINT_CHART_PAGE_H
#define INTEGRAL_PRINT_CHART_PAGE_H

#include "integral/frame/frame.h"
#include "integral/print/pitch_chart.h"

#include <string>
#include <vector>

namespace integral {

/// Default number of bars of a chart in each direction.
int default_bars(const LensSheet& sheet);

/// Distance, mm, from which a chart's middle bar looks even, if no other is given.
constexpr double default_chart_distance = 400;

/// Default difference from bar to bar, mm: a round number that changes the number of bands along a
/// bar by about an eighth from bar to bar. Throws as chart_bars does.
double default_step(const LensSheet& sheet, const Film& film, double distance);

/// A scale whose middle bar looks even, without bands, under the sheet from `distance` mm. All its
/// pitches are whole multiples of the step, so that they are round numbers. `first` may be 0 or
/// less if the step is too large.
PitchScale scale_about(const LensSheet& sheet, double distance, double step, int bars);

/// A chart for printing.
struct ChartPage {
    Frame frame;         ///< with its geometry
    std::string reading; ///< "Read it by: COMMAND", the page's last line
};

/// The geometry of a chart of a sheet: its aperture is for `distance` mm, and its sheet has no
/// offset.
FrameMetadata chart_geometry(FrameMetadata geometry, double distance);

/// The options that give a sheet, without its offset, and a film's pixel pitch.
std::string sheet_options(const LensSheet& sheet);
std::string film_option(const Film& film);

/// Draws the chart of a geometry's sheet on a page of its film. In the chart's geometry, the
/// aperture is for `distance`, and the sheet has no offset. Throws as pitch_chart does.
ChartPage chart_page(FrameMetadata geometry, const PitchScale& scale, double distance);

/// Writes a chart to a .pdf, on a page of its own size and with this title, or as a picture by
/// write_frame. Throws OutputError.
void write_chart(const std::string& path, const Frame& chart, const std::string& title);

/// The geometry with the measured pitch and index, for a sheet's file, which works with frames of
/// any size.
FrameMetadata corrected_sheet(FrameMetadata geometry, const MeasuredSheet& found);

} // namespace integral

#endif
