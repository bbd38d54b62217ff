// SPDX-License-Identifier: AGPL-3.0-or-later
// The parameters of `camera { integral ... }`, with their defaults and legal values.
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
    /// Width of the margin that is cut off all around after printing, mm. There the scene goes on;
    /// what is left shows what the camera shows without it.
    double bleed = 0;
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
    /// Scene units from the scene's eye to the sheet; determines the sheet's place and width.
    std::optional<double> sheet_distance;
    /// mm from the sheet to the viewer's eye. The scene's eye, and with it the view from the
    /// middle, stays in place unless move_eye is set. Empty: the distance of the scene's eye.
    std::optional<double> viewing_distance;
    /// K: the scene's eye moves K mm when the viewer's moves 1 mm (optics.md section 8), 0 to 100.
    /// Empty: the distance of the scene's eye divided by that of the viewer's eye; then depth at
    /// the sheet is true to scale.
    std::optional<double> parallax;
    /// Number of depth budgets on either side of the sheet for nine tenths of the picture, 0.1 to
    /// 100: the renderer chooses sheet_distance and parallax accordingly; a given one is kept.
    std::optional<double> fit;
    bool move_eye = false; ///< the scene's eye goes to viewing_distance, along its line of sight
    /// Width and height of the picture on paper, mm, without bleed; the frame must have
    /// print_pixels. Empty: the size follows from the frame's pixels.
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
    /// Range of the camera in front of the sheet (at most to the viewer) and behind it, mm; >= 0.
    /// Empty: from the aperture to infinity.
    std::optional<Vec2> depth_range;
    /// The scene lies where the viewer sees the projected image; sheet_distance is the distance of
    /// the sheet's image.
    std::optional<ProjectionWords> projection_lens;
    bool pseudoscopic = false; ///< Lippmann's single-stage capture: inverted in depth
};

/// The sentence for a bleed that uses up the film; empty for less bleed, and for a film without a
/// size.
std::string bleed_error(const Film& film);

/// Pixel width and height of a picture of print_size (which must be given) and its bleed on this
/// film.
PixelSize print_pixels(const CameraParameters& parameters);

/// 16 if there is an area to integrate over (the full model's lens, or a slit with a height), 4 for
/// the display prefilter, else 1: the pole.
int default_beam_samples(const CameraParameters& parameters);

/// 4 for the display prefilter, else 1: the pixel's centre.
int default_pixel_samples(const CameraParameters& parameters);

/// Checks each value by itself. Returns a sentence for every value out of range, with the value and
/// its legal range; empty if all are legal.
std::vector<std::string> find_value_errors(const CameraParameters& parameters);

/// Checks each value and, if all are legal, their combination. Returns a sentence for every fault.
/// make_camera checks what depends on the frame's size or the viewpoint.
std::vector<std::string> find_errors(const CameraParameters& parameters);

} // namespace integral

#endif
