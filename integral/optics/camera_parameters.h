// SPDX-License-Identifier: AGPL-3.0-or-later
// What `camera { integral ... }` can say, with its defaults and its legal values.
#ifndef INTEGRAL_OPTICS_CAMERA_PARAMETERS_H
#define INTEGRAL_OPTICS_CAMERA_PARAMETERS_H

#include "integral/optics/aperture.h"
#include "integral/optics/film.h"
#include "integral/optics/lens_mapping.h"
#include "integral/optics/lens_model.h"

#include <optional>
#include <string>
#include <vector>

namespace integral {

/// Film geometry as written in a scene: the frame's size in pixels comes with the render.
struct FilmParameters {
    Vec2 pixel_pitch{mm_per_inch / 300, mm_per_inch / 300}; ///< mm; 25.4 / dpi
    std::optional<double> units_per_mm; ///< scene units per mm on the sheet, if given
    Subpixels subpixels = {};
};

/// A lens before the sheet, or an array of them (projection.h).
struct ProjectionWords {
    double focal_length = 0, distance = 0; ///< mm, the latter from the sheet
    double columns = 1, rows = 1;          ///< macro-lenses across and down
};

/// An integral camera as a scene states it. The comments give units and defaults.
struct CameraParameters {
    LensSheet sheet;
    FilmParameters film;
    /// Scene units from the scene's eye to the sheet: where the sheet stands, and how wide it is.
    std::optional<double> sheet_distance;
    /// mm from the sheet to the viewer's eye. The scene's eye, and so the picture from the middle,
    /// stays the scene's own unless move_eye is given. Nothing: where the scene's eye is.
    std::optional<double> viewing_distance;
    /// K: the scene's eye moves K mm where the viewer's moves 1 mm (optics.md section 8), 0 to 100.
    /// Nothing: depth at the sheet is true, that is the scene's eye distance by the viewer's.
    std::optional<double> parallax;
    /// Depth budgets that nine tenths of the picture may reach either side of the sheet, 0.1 to 100:
    /// the renderer chooses sheet_distance and parallax for them, unless one is given.
    std::optional<double> fit;
    bool move_eye = false; ///< the scene's eye goes to viewing_distance, along its line of sight
    /// Width and height of the picture on paper, mm; the frame has to have print_pixels. Nothing:
    /// as large as the frame's pixels make it.
    std::optional<Vec2> print_size;
    std::optional<Vec2> capture_aperture; ///< mm; default: filling_aperture
    ApertureShape aperture_shape = ApertureShape::rectangle;
    LensModel model = LensModel::extended_pinhole;
    LensMapping mapping = LensMapping::automatic;
    /// Sample points on the lens's cell, 1 to 65536; default: default_beam_samples.
    std::optional<int> beam_samples;
    /// Sample points on the pixel's area, 1 to 65536; 1 is its centre; default:
    /// default_pixel_samples.
    std::optional<int> pixel_samples;
    bool display_prefilter = false; ///< see IntegralCamera
    /// How far the camera sees in front of the sheet (at most to the viewer) and behind it, mm;
    /// >= 0. Nothing: from the aperture to infinity.
    std::optional<Vec2> depth_range;
    /// The scene is where the viewer sees the projected image: sheet_distance is that of the
    /// sheet's.
    std::optional<ProjectionWords> projection_lens;
    bool pseudoscopic = false; ///< Lippmann's single-stage capture: inverted in depth
};

/// Pixels across and down a picture of print_size (which must be given) on this film.
PixelSize print_pixels(const CameraParameters& parameters);

/// 16 where there is an area to integrate over (the full model's lens, or a slit that has height),
/// 4 for the display prefilter, else 1: the pole.
int default_beam_samples(const CameraParameters& parameters);

/// 4 for the display prefilter, else 1: the pixel's centre.
int default_pixel_samples(const CameraParameters& parameters);

/// Checks each value by itself. Returns a sentence for every value out of range, which names the
/// value and what is legal; empty if all are legal.
std::vector<std::string> find_value_errors(const CameraParameters& parameters);

/// Checks each value, and if all are legal, how they go together. Returns a sentence for every
/// fault. What depends on the frame's size or the viewpoint is left to make_camera.
std::vector<std::string> find_errors(const CameraParameters& parameters);

} // namespace integral

#endif
