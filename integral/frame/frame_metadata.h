// SPDX-License-Identifier: AGPL-3.0-or-later
// The metadata of a micro-image frame: the JSON document `integral` in a PNG iTXt chunk, an EXR
// string attribute, the TIFF ImageDescription, or the file FRAME.json next to the frame FRAME.
#ifndef INTEGRAL_FRAME_FRAME_METADATA_H
#define INTEGRAL_FRAME_FRAME_METADATA_H

#include "integral/frame/error_estimate.h"
#include "integral/frame/view_grid.h"
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
    int draft = 1;                      ///< width of a pixel, in pixels of the final frame
    double seconds = 0;                 ///< rendering time; 0 if unknown
    std::string fit; ///< the words for the camera that Integral_Fit chose; empty: no fit
    std::optional<ErrorEstimate> error; ///< in the output encoding
    std::optional<Vec2> phase; ///< Integral_Phase, x to y; nothing: the whole zone was rendered
};

/// The geometry of a micro-image frame, which replay needs. Lengths in mm.
struct FrameMetadata {
    LensSheet sheet;
    Film film;
    Aperture aperture;
    std::optional<Placement> placement;       ///< where the sheet stood in its scene
    std::optional<ProjectionLens> projection; ///< as in IntegralCamera: `placement` then places the
                                              ///< sheet's projected image
    std::optional<Parallax> parallax; ///< nothing: the viewer's eye is the scene's own eye
    Encoding encoding;
    std::optional<RenderRecord> render;
    std::optional<QuiltRecord> quilt; ///< if set, the picture consists of views of the frame
};

/// Maps places in the scene to where the viewer sees them (Parallax), both in the sheet frame; the
/// identity without `parallax`.
Collineation relief_of(const FrameMetadata& metadata);

/// Distances from the sheet, or its projected image, to the viewer's eye and to the scene's own,
/// mm.
double viewer_distance(const FrameMetadata& metadata);
double scene_distance(const FrameMetadata& metadata);

/// The JSON document with the objects `sheet`, `film`, `aperture` and `encoding`, and, if set,
/// `camera`, `projection`, `parallax`, `render` and `quilt`. Numbers are written so that they read
/// back as the same double.
std::string to_json(const FrameMetadata& metadata);

/// The inverse of to_json. Throws std::invalid_argument with the name of a field that is missing,
/// of the wrong type or out of range. `film.width` and `film.height` may be absent, as in a sheet
/// file; they are then 0.
FrameMetadata frame_metadata_from_json(const std::string& text);

} // namespace integral

#endif
