// SPDX-License-Identifier: AGPL-3.0-or-later
// Describes light-field panels: a display's pixels and the lens sheet on them.
#ifndef INTEGRAL_SHEET_PANEL_H
#define INTEGRAL_SHEET_PANEL_H

#include "integral/frame/frame_metadata.h"
#include "integral/sheet/looking_glass.h"

#include <optional>
#include <string>
#include <vector>

namespace integral {

/// A panel, described like a frame that is rendered for it: with the sheet's own pitch, not its
/// micro-images' pitch. Lengths in mm.
struct Panel {
    std::string name;
    Film film; ///< its pixels, upright, as its viewer sees them
    LensSheet sheet;
    Aperture aperture;       ///< the viewers' zone (default: micro-images as wide as lenses)
    bool mirrored_x = false; ///< its pixels run from right to left,
    bool mirrored_y = false; ///< or from bottom to top: the image sent to it must be mirrored
    /// The calibration that the panel was made from, if any, in Looking Glass's form. Views are
    /// then interlaced by the calibration's mapping.
    std::optional<LookingGlassCalibration> calibration;
};

/// Refractive index of polymethyl methacrylate, the material of lens sheets.
constexpr double nominal_ior = 1.49;

/// The physical panel that a calibration describes, for eyes at a distance (mm; nothing:
/// nominal_viewing_distance).
///
/// A calibration has the pitch of the micro-images, M, and not the lenses' pitch, p; with k = t/(n
/// d), M = p (1 + k), paraxially. The points whose phase is a half modulo 1 form a lattice: that of
/// the lenses' axes, enlarged by 1 + k about the sheet's centre. The maker's formula for stripes
/// takes red, green and blue at 0, 1/3 and 2/3 of a pixel to the right of the pixel's centre, but
/// the stripes are at -1/3, 0 and 1/3. So the true lattice is a third of a pixel away from the
/// formula's. The thickness is chosen so that a lens's cell spans the view cone. Throws
/// std::invalid_argument if the sheet or the distance is out of range.
Panel panel_from(const LookingGlassCalibration& calibration,
                 std::optional<double> viewing_distance = {}, double ior = nominal_ior);

/// Panels known by name: the thesis's, and current light-field displays with their maker's nominal
/// figures. Individual displays differ from these figures: each has its own calibration. Names are
/// words joined by hyphens.
const std::vector<Panel>& known_panels();

/// A panel of known_panels by its name; nothing for other names.
std::optional<Panel> panel_named(const std::string& name);

/// The known panel of a name, or the panel described by a file whose name ends in .json. Throws
/// std::invalid_argument for other names, InputError for a file that cannot be used.
Panel find_panel(const std::string& name);

/// The panel for eyes at another distance, mm, with the zone whose micro-images there are as wide
/// as the lenses. Throws std::invalid_argument if no finite zone has such micro-images.
Panel seen_from(const Panel& panel, double distance);

/// Reads a panel description: a document of our own, or a calibration of Looking Glass or of
/// CubeVi, recognised by its fields. The document is
///
///     {"panel": {"name": "...", "width": 1024, "height": 768, "pixel_pitch_mm": 0.207,
///     "subpixels": "rgb", "mirrored": "x"},
///      "sheet": {"arrangement": "lenticular", "pitch_mm": 1.27, "thickness_mm": 3.08, "ior": 1.6,
///      "slant_degrees": 0, "offset_mm": [0, 0]}, "viewing_distance_mm": 300}
///
/// Fields that a frame's document has too mean the same as there; pixel_pitch_mm may be [x, y], the
/// sheet may have micro_image_pitch_mm in place of pitch_mm, and `aperture` may stand in place of
/// viewing_distance_mm. A maker's calibration may be added as `calibration`, or stand in place of
/// panel and sheet. In the latter case `ior` may be given for the sheet derived from the
/// calibration. Throws std::invalid_argument naming the field.
Panel panel_from_json(const std::string& text);

/// Writes our own form of a description; panel_from_json reads it back to the same doubles.
std::string to_json(const Panel& panel);

/// Geometry of a frame that is native to the panel.
FrameMetadata frame_geometry(const Panel& panel);

} // namespace integral

#endif
