// SPDX-License-Identifier: AGPL-3.0-or-later
// Light-field panels: a display's pixels and the lens sheet on them.
#ifndef INTEGRAL_OUTPUT_PANEL_H
#define INTEGRAL_OUTPUT_PANEL_H

#include "integral/lightfield/frame_metadata.h"
#include "integral/output/looking_glass.h"

#include <optional>
#include <string>
#include <vector>

namespace integral {

/// A panel as a frame for it is rendered: by the sheet's own pitch, not that of its micro-images. Lengths in mm.
struct Panel {
    std::string name;
    Film film;               ///< its pixels, upright, as its viewer sees them
    LensSheet sheet;
    Aperture aperture;       ///< where its viewers' eyes are: the zone that its lenses fill, at its distance
    bool mirrored_x = false; ///< its pixels run from right to left,
    bool mirrored_y = false; ///< or from the bottom to the top: the image it is sent has to be mirrored
    /// What it was made of, where that was a calibration in the manner of Looking Glass; views are then interlaced by its own mapping.
    std::optional<LookingGlassCalibration> calibration;
};

/// Panels that are known by name: the thesis's, and current light-field displays with nominal figures, whose single pieces
/// differ (each has a calibration of its own).
const std::vector<Panel>& known_panels();

/// A panel of known_panels by its name; nothing for another name.
std::optional<Panel> panel_named(const std::string& name);

/// A panel description: a document of our own, or a Looking Glass calibration, told apart by their fields.
/// Throws std::invalid_argument naming the field.
Panel panel_from_json(const std::string& text);

/// Our own form of it; panel_from_json reads it back to the same doubles.
std::string to_json(const Panel& panel);

/// Geometry of a frame that is native to the panel.
FrameMetadata frame_geometry(const Panel& panel);

/// The words of an integral camera that renders for the panel, without braces: lens_sheet { ... } film { ... } capture_aperture ...
std::string camera_words(const Panel& panel);

} // namespace integral

#endif
