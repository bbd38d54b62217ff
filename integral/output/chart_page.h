// SPDX-License-Identifier: AGPL-3.0-or-later
// A pitch chart's page for one sheet and printer: its scale, the chart, and how it is read.
#ifndef INTEGRAL_OUTPUT_CHART_PAGE_H
#define INTEGRAL_OUTPUT_CHART_PAGE_H

#include "integral/lightfield/frame.h"
#include "integral/output/pitch_chart.h"

#include <string>
#include <vector>

namespace integral {

/// How many bars a chart has in each direction unless it is said.
int default_bars(const LensSheet& sheet);

/// The difference from bar to bar unless it is said, mm: a round number by which neighbouring bars
/// differ by about an eighth of a band along a bar. Throws as chart_bars does.
double default_step(const LensSheet& sheet, const Film& film);

/// A scale whose middle bar is even under the sheet as it is seen from 400 mm. All its pitches are
/// whole multiples of the step, so that they are round numbers. `first` may come out as 0 or less
/// where the step is too large.
PitchScale scale_about(const LensSheet& sheet, double step, int bars);

/// A chart as it is printed.
struct ChartPage {
    Frame frame;         ///< with its geometry
    std::string reading; ///< "Read it by: COMMAND", the page's last line
};

/// Draws the chart of a geometry's sheet on a page of its film. Of the rest of the geometry nothing
/// is kept. Throws as pitch_chart does.
ChartPage chart_page(FrameMetadata geometry, const PitchScale& scale);

/// Writes a chart to a .pdf, on a page of its own size, or to a picture's file as write_frame does.
/// Throws OutputError.
void write_chart(const std::string& path, const Frame& chart);

/// A geometry with the pitch and the index that were measured, for a sheet's file, which goes with
/// frames of any size.
FrameMetadata corrected_sheet(FrameMetadata geometry, const MeasuredSheet& found);

} // namespace integral

#endif
