// SPDX-License-Identifier: AGPL-3.0-or-later
// The settings that the studio's page changes: a sheet, a print and its viewer, or a panel, and
// where the sheet stands in the scene; and the figures that follow from them.
#ifndef INTEGRAL_STUDIO_PLACEMENT_SETTINGS_H
#define INTEGRAL_STUDIO_PLACEMENT_SETTINGS_H

#include "integral/frame/depth_range.h"
#include "integral/sheet/panel.h"
#include "integral/sheet/scene_fit.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>

namespace integral {

/// Lengths in mm, unless stated otherwise.
struct PlacementSettings {
    std::optional<Panel> panel; ///< in place of the next four; its name is --panel's argument
    LensSheet sheet;
    double dpi = 720; ///< of the printer
    Vec2 print;       ///< width and height of the picture, > 0
    double viewing_distance = 400;
    std::optional<double> sheet_distance; ///< scene units from the scene's eye; empty: fitted
    std::optional<double> parallax;       ///< empty: fitted
    double budgets = 2; ///< for the fit: depth budgets on either side of the sheet, > 0
};

/// Settings to begin with: a lenticular sheet of 60 lenses per inch at 720 dpi, fitted. The print
/// has no size yet.
PlacementSettings first_settings();

/// A print with 150 mm on the longer side and that aspect (width / height).
Vec2 print_of_aspect(double aspect);

/// Reads a JSON object with the fields sheet (as in a frame's document), dpi, print_mm,
/// viewing_distance_mm, budgets and, optional or null, panel (as panel_from_json reads it),
/// sheet_distance and parallax. Throws std::invalid_argument, "FIELD what is wrong with it".
PlacementSettings settings_from_json(const std::string& text);
nlohmann::ordered_json json_of(const PlacementSettings& settings);

/// The print's or panel's frame for these settings. `probe`: depths of the scene with its
/// placement; gives the scene's camera, and its distances for the fit. Without it, or without a
/// placement in it, the geometry has no placement. Throws std::invalid_argument if a number is out
/// of range.
FrameMetadata frame_of_settings(const PlacementSettings& settings, const DepthFrame* probe);

/// The words of Integral_Camera= for that frame.
std::string words_of_settings(const PlacementSettings& settings, const FrameMetadata& frame);

/// Figures for the page: the frame's document (geometry), the placement, budget_mm, the
/// distances at which surfaces are seen one and two budgets from the sheet (scene units from the
/// eye; null: infinitely far), the shares of the picture that are sharp, soft and beyond, the fits
/// to one and to two budgets, pixels and lenses.
nlohmann::ordered_json settings_figures(const PlacementSettings& settings, const DepthFrame* probe);

} // namespace integral

#endif
