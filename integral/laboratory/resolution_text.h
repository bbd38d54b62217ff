// SPDX-License-Identifier: AGPL-3.0-or-later
// The tables of the resolution experiment, next to the thesis's.
#ifndef INTEGRAL_LABORATORY_RESOLUTION_TEXT_H
#define INTEGRAL_LABORATORY_RESOLUTION_TEXT_H

#include "integral/base/json.h"
#include "integral/laboratory/resolution.h"

#include <string>
#include <vector>

namespace integral {

/// A table of the thesis: an entry for each depth (mm) and frequency (lines per mm, from high to
/// low). "x": not resolved; "v": resolved, without a figure.
struct ThesisTable {
    const char* name;
    double pitch, thickness, ior; ///< mm, mm
    std::vector<double> frequencies, depths;
    std::vector<std::vector<std::string>> cells;
};

/// Tables 4-2 and 4-3.
const std::vector<ThesisTable>& thesis_tables();

/// One line each for the thesis, the screen, the limit by lens and pixel, and the eye, at each
/// depth. `thesis`: the table to compare with; nullptr: none.
std::string resolution_text(const ResolutionRequest& request, const ResolutionTable& table,
                            const ThesisTable* thesis);
Json resolution_json(const ResolutionRequest& request, const ResolutionTable& table);

struct ResolutionReport {
    std::string text;
    Json json = Json::array();
};

/// Runs the experiment with the request's sheet or, if `beside_thesis`, with each of the thesis's
/// sheets, whose tables it then shows as well. Throws as measured_resolution does.
ResolutionReport resolution_report(ResolutionRequest request, bool beside_thesis, int threads,
                                   const Progress& progress);

} // namespace integral

#endif
