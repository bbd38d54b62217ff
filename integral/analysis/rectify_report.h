// SPDX-License-Identifier: AGPL-3.0-or-later
// What is said of a scan that was rectified: the lattice that was found, and what was done to the
// light.
#ifndef INTEGRAL_ANALYSIS_RECTIFY_REPORT_H
#define INTEGRAL_ANALYSIS_RECTIFY_REPORT_H

#include "integral/analysis/lattice_search.h"
#include "integral/lightfield/image.h"

#include <nlohmann/json.hpp>

#include <string>

namespace integral {

/// Corrections of a scan's light, in the order in which they are made.
class LightReport {
public:
    /// The light was evened by a flat-field scan, a fitted surface, or both; `ratio` is the
    /// greatest over the least light before.
    void add_evened(bool by_flat, bool by_surface, double ratio);
    /// The colours were multiplied by `gains`, found by a white patch or else by the grey world.
    void add_balanced(bool by_white_patch, Colour gains);
    /// Micro-images were flattened whose average fell to `least` of its brightest place.
    void add_flattened(double least);

    const nlohmann::ordered_json& json() const { return json_; }
    const std::string& text() const { return text_; } ///< empty if there were none

private:
    void add_text(const std::string& what);
    nlohmann::ordered_json json_ = nlohmann::ordered_json::object();
    std::string text_;
};

/// The figures for programs. `film` is that of the new frame.
nlohmann::ordered_json rectify_json(const FoundLattice& found, const LatticeSearch& search,
                                    const Film& film, const LightReport& light);

/// The figures for people: some lines.
std::string rectify_text(const FoundLattice& found, const LatticeSearch& search, const Film& film,
                         const LightReport& light);

} // namespace integral

#endif
