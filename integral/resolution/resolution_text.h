// SPDX-License-Identifier: AGPL-3.0-or-later
// The tables of the resolution experiment, beside the thesis's.
#ifndef INTEGRAL_RESOLUTION_RESOLUTION_TEXT_H
#define INTEGRAL_RESOLUTION_RESOLUTION_TEXT_H

#include "integral/resolution/resolution.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace integral {

/// A table of the thesis: what it says at each depth (mm) for its frequencies (lines per mm, from
/// high to low). "x": not resolved; "v": resolved, without a figure.
struct ThesisTable {
    const char* name;
    double pitch, thickness, ior; ///< mm, mm
    std::vector<double> frequencies, depths;
    std::vector<std::vector<std::string>> cells;
};

/// Tables 4-2 and 4-3.
const std::vector<ThesisTable>& thesis_tables();

/// One line for the thesis, the screen, the eye and what lens and pixel let through, at each depth.
/// `thesis`: the table to print beside; nullptr: none.
std::string resolution_text(const ResolutionRequest& request, const ResolutionTable& table,
                            const ThesisTable* thesis);
nlohmann::ordered_json resolution_json(const ResolutionRequest& request,
                                       const ResolutionTable& table);

struct ResolutionReport {
    std::string text;
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
};

/// The experiment with the request's sheet, or with each of the thesis's sheets in its place and
/// the thesis's table beside. Throws as measured_resolution does.
ResolutionReport resolution_report(ResolutionRequest request, bool beside_thesis, int threads,
                                   const Progress& progress);

} // namespace integral

#endif
