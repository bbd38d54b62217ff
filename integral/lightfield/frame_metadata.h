// SPDX-License-Identifier: AGPL-3.0-or-later
// What a micro-image frame carries about itself: the document `integral` in its PNG iTXt chunk,
// EXR string attribute, TIFF ImageDescription, or FRAME.json beside it.
#ifndef INTEGRAL_LIGHTFIELD_FRAME_METADATA_H
#define INTEGRAL_LIGHTFIELD_FRAME_METADATA_H

#include "integral/lightfield/error_estimate.h"
#include "integral/lightfield/view_grid.h"
#include "integral/optics/camera.h"

#include <optional>
#include <string>

namespace integral {

/// The part of the document that says how the frame came about; absent for other programs' frames.
struct RenderRecord {
    std::string program; ///< name and version
    std::string scene;   ///< the scene file's name, without folders
    LensModel model = LensModel::extended_pinhole;
    LensMapping mapping = LensMapping::automatic;
    int pixel_samples = 1, beam_samples = 1;
    bool pseudoscopic = false, display_prefilter = false;
    double seconds = 0;                 ///< of rendering, where known
    std::optional<ErrorEstimate> error; ///< in the output encoding, where known
};

/// Geometry of a micro-image frame: enough to replay it. Lengths in mm.
struct FrameMetadata {
    LensSheet sheet;
    Film film;
    Aperture aperture;
    std::optional<Placement> placement; ///< where the sheet stood in its scene
    Encoding encoding;
    std::optional<RenderRecord> render;
    std::optional<QuiltRecord> quilt; ///< the picture is not the frame, but views of it
};

/// The JSON document, of objects `sheet`, `film`, `aperture`, `camera`, `render` (interfaces.md),
/// `quilt`. Numbers are written so that they read back to the same double.
std::string to_json(const FrameMetadata& metadata);

/// Inverse. Throws std::invalid_argument naming the field that is missing, of the wrong type or
/// out of range. `film.width`/`height` may be absent (a bare sheet file): they come back as 0.
FrameMetadata frame_metadata_from_json(const std::string& text);

} // namespace integral

#endif
