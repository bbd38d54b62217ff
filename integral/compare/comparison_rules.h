// SPDX-License-Identifier: AGPL-3.0-or-later
// A user's rules for comparing pictures, and the settings that follow from them for two pictures.
#ifndef INTEGRAL_COMPARE_COMPARISON_RULES_H
#define INTEGRAL_COMPARE_COMPARISON_RULES_H

#include "integral/compare/compare.h"

#include <optional>
#include <string>
#include <vector>

namespace integral {

constexpr double least_ppd = 1, greatest_ppd = 1000;

/// The eyes from which frames are seen.
struct SeenEyes {
    int columns = 0, rows = 0; ///< a grid over the viewing zone; 0: nine eyes, which are spread
                               ///< across the lenses
    std::vector<Vec3> places;  ///< mm from the sheet's centre, z the distance; replace the grid
};

struct ComparisonRules {
    double channel_tolerance = default_channel_tolerance;
    bool flip = false;         ///< whether FLIP is computed
    std::optional<double> ppd; ///< pixels per degree for FLIP; empty: from the geometry
    std::vector<Region> regions;
    std::string mask; ///< path of the picture of weights; empty: none
    /// The limits apply to the frames' views from these eyes; empty: to the frames' pixels. Regions
    /// that are ignored are made equal in the views, too; other weights apply to pixels alone.
    std::optional<SeenEyes> seen;
};

/// Pixels per degree at which a frame's viewer sees its film: by the geometric mean of the pitches,
/// at the middle of the film.
double pixels_per_degree(const FrameMetadata& metadata);

/// Settings for two pictures, by their forms and metadata alone. FLIP's exposures are left empty:
/// see needs_exposures. Throws std::invalid_argument as PixelWeights does, InputError where the
/// mask cannot be read.
ComparisonSettings settings_of(const ComparisonRules& rules, const Frame& a, const Frame& b);

/// Whether FLIP of these pictures is HDR-FLIP: that is, whether one of them holds floats.
bool needs_exposures(const Image& a, const Image& b);

/// Adds rows of the reference's pixels to the meter.
void meter_rows(FlipExposureMeter& meter, const Image& rows);

/// Settings for two pictures in memory, with FLIP's exposures. Throws as settings_of does.
ComparisonSettings settings_in_memory(const ComparisonRules& rules, const Frame& reference,
                                      const Frame& result);

} // namespace integral

#endif
