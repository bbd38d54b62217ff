// SPDX-License-Identifier: AGPL-3.0-or-later
// The integral camera: a sheet, its film and its aperture, placed in a scene.
#ifndef INTEGRAL_OPTICS_CAMERA_H
#define INTEGRAL_OPTICS_CAMERA_H

#include "integral/optics/beam.h"

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

/// Everything that `camera { integral ... }` can say, as written; units in the comments.
struct CameraParameters {
    LensSheet sheet;
    FilmParameters film;
    std::optional<double> sheet_distance; ///< scene units from the aperture's centre
    std::optional<Vec2> capture_aperture; ///< mm; default: filling_aperture
    ApertureShape aperture_shape = ApertureShape::rectangle;
    LensModel model = LensModel::extended_pinhole;
    LensMapping mapping = LensMapping::automatic;
    std::optional<int> beam_samples;  ///< points of the lens's cell, 1 to 65536; default:
                                      ///< default_beam_samples
    std::optional<int> pixel_samples; ///< points of the pixel's area, 1 to 65536; 1: its centre;
                                      ///< default: default_pixel_samples
    bool display_prefilter = false;   ///< points also of the neighbouring pixels and lenses, see
                                      ///< IntegralCamera
    std::optional<Vec2> depth_range;  ///< mm seen in front of (up to the aperture) and behind the
                                      ///< sheet; >= 0
    bool pseudoscopic = false;        ///< Lippmann's single-stage capture: inverted in depth
};

/// 16 where there is something to integrate over (the full model's lens, a slit's height), 4 for
/// the display prefilter, else 1: the pole.
int default_beam_samples(const CameraParameters& parameters);

/// 4 for the display prefilter, else 1: the pixel's centre.
int default_pixel_samples(const CameraParameters& parameters);

/// The perspective camera that an integral camera starts from, in scene units.
struct ViewFrame {
    Vec3 location, direction, right, up; ///< as POV-Ray has them after look_at and transforms
    double sheet_distance_ratio = 1;     ///< sheet distance / |direction|; survives transforms
};

/// Sheet frame (mm) -> scene: an affine map whose columns are one mm along x, y, z.
struct Placement {
    Vec3 origin, x, y, z;
    double units_per_mm = 1;   ///< k
    bool right_angled = false; ///< the axes are at right angles, to rounding: all lengths change by
                               ///< k
};

inline Vec3 scene_from_sheet(const Placement& p, Vec3 v)
{
    return p.origin + v.x * p.x + v.y * p.y + v.z * p.z;
}

/// Inverse of scene_from_sheet.
Vec3 sheet_from_scene(const Placement& placement, Vec3 point);

/// One integral camera, ready to render W x H pixels: immutable.
struct IntegralCamera {
    SheetOptics optics;
    Film film;
    Placement placement;
    LensMapping mapping = LensMapping::automatic;
    std::optional<Vec2> depth_range;
    int pixel_samples = 1, beam_samples = 1;
    bool pseudoscopic = false;
    /// Samples are weighted by a tent, two pixels and two cells wide, about pixel and pole, in
    /// place of the box of one: a low-pass at the bandwidth of the sheet, which takes what it
    /// cannot show (Zwicker et al. 2006, with a tent for their ideal filter). All are of the
    /// pixel's own lens, as if its micro-image did not end.
    bool display_prefilter = false;

    /// Height (mm) of a lenticular sheet's slit at a point of the aperture plane; 0 for other
    /// sheets.
    double slit_height(Vec2 aperture_point) const;
};

/// Says which single values are out of range, a sentence each that names the value and what is
/// legal; empty if none.
std::vector<std::string> find_value_errors(const CameraParameters& parameters);

/// The same, and what is wrong with the values taken together, whatever the frame's size and
/// the viewpoint.
std::vector<std::string> find_errors(const CameraParameters& parameters);

/// Builds the camera for a frame of width x height pixels.
/// Throws std::invalid_argument with a sentence for the user where the parameters cannot work.
IntegralCamera make_camera(const CameraParameters& parameters, const ViewFrame& view, int width,
                           int height);

/// A line of sight, in the scene: from `origin`, where the viewer's side of it starts, into the
/// scene; `length` is how far it is seen (0 = without end).
struct SightLine {
    Vec3 origin, direction; ///< direction is a unit vector of the scene
    double length = 0;
};

/// Step 6 of optics.md section 3: the one ray, from the aperture (or depth_range's front) through
/// the lens to infinity (or depth_range's back), that returns what the viewer would see.
/// pseudoscopic: from the sheet, which in Lippmann's capture sees nothing of what is behind it.
SightLine sight_line(const IntegralCamera& camera, const BeamRay& ray);

/// A parallelogram in the scene: centre + a*half_x + b*half_y, a and b in [-1, 1].
struct StartRegion {
    Vec3 centre, half_x, half_y;
};

/// Where the sight lines of all rays of the pixels' beams start. Nothing: nowhere in particular, as
/// the rays of hybrid, full and the display prefilter may pass the aperture's plane anywhere.
std::optional<StartRegion> start_region(const IntegralCamera& camera);

/// The film point that a lens images where `film_point` would have to be for the sheet to show its
/// scene inverted in depth: mirrored at the lens's pole (lenticular: its axis). Its own inverse. A
/// single-stage capture puts on film point F what belongs at this one.
Vec2 mirrored_in_lens(const SheetOptics& optics, Vec2 film_point, LensIndex lens);

/// What a camera makes of its film, from an even sample of at most `samples` pixels.
struct Coverage {
    double imaged = 0; ///< fractions of the film's pixels; these three add up to 1
    double outside_aperture = 0;
    double total_reflection = 0;
    double searched = 0; ///< imaged, but only by the accurate search
};
Coverage coverage(const IntegralCamera& camera, int samples);

} // namespace integral

#endif
