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

/// A panel as a frame for it is rendered: by the sheet's own pitch, not that of its micro-images.
/// Lengths in mm.
struct Panel {
    std::string name;
    Film film; ///< its pixels, upright, as its viewer sees them
    LensSheet sheet;
    Aperture aperture;       ///< where its viewers' eyes are: the zone that its lenses fill, at its
                             ///< distance
    bool mirrored_x = false; ///< its pixels run from right to left,
    bool mirrored_y = false; ///< or from the bottom to the top: the image it is sent has to be
                             ///< mirrored
    /// What it was made of, where that was a calibration in the manner of Looking Glass; views are
    /// then interlaced by its own mapping.
    std::optional<LookingGlassCalibration> calibration;
};

/// Polymethyl methacrylate, of which lens sheets are made.
constexpr double nominal_ior = 1.49;

/// The physical panel that a calibration speaks of, for eyes at a distance (mm; nothing:
/// nominal_viewing_distance).
///
/// A calibration has the pitch of the micro-images, M, and not that of the lenses, p; with k = t/(n
/// d), M = p (1 + k), paraxially. Views lie along the lattice of points whose phase is a half
/// modulo 1, which is that of the lenses' axes enlarged by 1 + k about the sheet's centre. The
/// formula for stripes takes red, green and blue at 0, 1/3 and 2/3 of a pixel to the right of the
/// pixel's centre, and they are at -1/3, 0 and 1/3: the lattice is a third of a pixel from where it
/// says. The thickness is that of lenses which fill the view cone. Throws std::invalid_argument
/// where the views run the other way than behind lenses.
Panel panel_from(const LookingGlassCalibration& calibration,
                 std::optional<double> viewing_distance = {}, double ior = nominal_ior);

/// Panels that are known by name: the thesis's, and current light-field displays with their maker's
/// nominal figures, from which single pieces differ (each has a calibration of its own). Names are
/// words joined by hyphens.
const std::vector<Panel>& known_panels();

/// A panel of known_panels by its name; nothing for another name.
std::optional<Panel> panel_named(const std::string& name);

/// The panel of that name, or the one that a file whose name ends in .json describes. Throws
/// std::invalid_argument for other names, InputError for a file that cannot be used.
Panel find_panel(const std::string& name);

/// The panel for eyes at another distance, mm: the zone is what its lenses fill there. Throws
/// std::invalid_argument where nothing fills them.
Panel seen_from(const Panel& panel, double distance);

/// A panel description: a document of our own, or a calibration of Looking Glass or of CubeVi, told
/// apart by their fields. The document is
///
///     {"panel": {"name": "...", "width": 1024, "height": 768, "pixel_pitch_mm": 0.207,
///     "subpixels": "rgb", "mirrored": "x"},
///      "sheet": {"arrangement": "lenticular", "pitch_mm": 1.27, "thickness_mm": 3.08, "ior": 1.6,
///      "slant_degrees": 0, "offset_mm": [0, 0]}, "viewing_distance_mm": 300}
///
/// with the fields of a frame's document where they are the same; pixel_pitch_mm may be [x, y], the
/// sheet may have micro_image_pitch_mm in place of pitch_mm, and `aperture` may stand in place of
/// viewing_distance_mm. `calibration`, a maker's calibration, may be there too, and in place
/// of panel and sheet; beside it, `ior` is that of the sheet that is made of it. Throws
/// std::invalid_argument naming the field.
Panel panel_from_json(const std::string& text);

/// Our own form of it; panel_from_json reads it back to the same doubles.
std::string to_json(const Panel& panel);

/// Geometry of a frame that is native to the panel.
FrameMetadata frame_geometry(const Panel& panel);

} // namespace integral

#endif
