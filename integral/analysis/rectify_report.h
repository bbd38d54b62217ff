// SPDX-License-Identifier: AGPL-3.0-or-later
// Reports on a rectified scan: the lattice found, and the corrections of the light.
#ifndef INTEGRAL_ANALYSIS_RECTIFY_REPORT_H
#define INTEGRAL_ANALYSIS_RECTIFY_REPORT_H

#include "integral/analysis/lattice_search.h"
#include "integral/base/json.h"
#include "integral/frame/image.h"

#include <string>

namespace integral {

/// Corrections of a scan's light, in the order in which they are made.
class LightReport {
public:
    /// The light was evened by a flat-field scan, a fitted surface, or both; `ratio` is the
    /// greatest light over the least, before that.
    void add_evened(bool by_flat, bool by_surface, double ratio);
    /// The colours were multiplied by `gains`, from a white patch or else from the grey world.
    void add_balanced(bool by_white_patch, Colour gains);
    /// The micro-images were flattened. Light in their average fell to `least` of its maximum.
    void add_flattened(double least);

    const Json& json() const { return json_; }
    const std::string& text() const { return text_; } ///< empty without corrections

private:
    void add_text(const std::string& what);
    Json json_ = Json::object();
    std::string text_;
};

/// The figures as JSON. `film` is the new frame's.
Json rectify_json(const FoundLattice& found, const LatticeSearch& search, const Film& film,
                  const LightReport& light);

/// The figures as text, in several lines.
std::string rectify_text(const FoundLattice& found, const LatticeSearch& search, const Film& film,
                         const LightReport& light);

} // namespace integral

#endif
