// SPDX-License-Identifier: AGPL-3.0-or-later
// The metadata of a micro-image frame: the JSON document `integral` in a PNG iTXt chunk, an EXR
// string attribute, the TIFF ImageDescription, or in FRAME.json in the frame's folder.
#ifndef INTEGRAL_LIGHTFIELD_FRAME_METADATA_H
#define INTEGRAL_LIGHTFIELD_FRAME_METADATA_H

#include "integral/lightfield/error_estimate.h"
#include "integral/lightfield/view_grid.h"
#include "integral/optics/camera.h"

#include <optional>
#include <string>

namespace integral {

/// The part of the document about rendering; absent for frames of other programs.
struct RenderRecord {
    std::string program; ///< name and version
    std::string scene;   ///< the scene file's name, without folders
    LensModel model = LensModel::extended_pinhole;
    LensMapping mapping = LensMapping::automatic;
    int pixel_samples = 1, beam_samples = 1;
    bool pseudoscopic = false, display_prefilter = false;
    int draft = 1;                      ///< pixels of the final frame across one of this frame's
    double seconds = 0;                 ///< rendering time; 0 if unknown
    std::string fit; ///< the camera's words that Integral_Fit chose; empty: no fit
    std::optional<ErrorEstimate> error; ///< in the output encoding
};

/// The geometry of a micro-image frame, which replay needs. Lengths in mm.
struct FrameMetadata {
    LensSheet sheet;
    Film film;
    Aperture aperture;
    std::optional<Placement> placement;       ///< where the sheet stood in its scene
    std::optional<ProjectionLens> projection; ///< as IntegralCamera has it: `placement` is that of
                                              ///< the sheet's projected image
    std::optional<Parallax> parallax; ///< nothing: the viewer's eye was the scene's own
    Encoding encoding;
    std::optional<RenderRecord> render;
    std::optional<QuiltRecord> quilt; ///< if set, the picture holds views of the frame instead
};

/// From where things stood in the scene to where the viewer sees them (Parallax), both in the sheet
/// frame: the identity without `parallax`.
Collineation relief_of(const FrameMetadata& metadata);

/// mm from the sheet, or its projected image, to the viewer's eye and to the scene's own.
double viewer_distance(const FrameMetadata& metadata);
double scene_distance(const FrameMetadata& metadata);

/// The JSON document with the objects `sheet`, `film`, `aperture`, `camera`, `render` (see
/// interfaces.md) and `quilt`. Numbers are written so that they read back as the same double.
std::string to_json(const FrameMetadata& metadata);

/// The inverse of to_json. Throws std::invalid_argument with the name of a field that is missing,
/// of the wrong type or out of range. `film.width` and `film.height` may be absent, as in a sheet
/// file; they are then 0.
FrameMetadata frame_metadata_from_json(const std::string& text);

} // namespace integral

#endif
