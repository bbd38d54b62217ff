// SPDX-License-Identifier: AGPL-3.0-or-later
// The integral camera: a sheet, its film and its aperture, placed in a scene; and the scene's rays
// that correspond to the rays behind its lenses.
#ifndef INTEGRAL_OPTICS_CAMERA_H
#define INTEGRAL_OPTICS_CAMERA_H

#include "integral/optics/beam.h"
#include "integral/optics/camera_parameters.h"
#include "integral/optics/collineation.h"
#include "integral/optics/projection.h"

#include <optional>

namespace integral {

/// The perspective camera from which an integral camera is made, in scene units.
struct ViewFrame {
    Vec3 location, direction, right, up; ///< as in POV-Ray after look_at and transforms
    double sheet_distance_ratio = 1;     ///< sheet distance / |direction|; survives transforms
};

/// Sheet frame (mm) -> scene: an affine map whose columns are one mm along x, y, z.
struct Placement {
    Vec3 origin, x, y, z;
    double units_per_mm = 1; ///< k
    /// Whether the axes are at right angles, to rounding: then every length is scaled by k.
    bool right_angled = false;
    double sheet_distance = 0;   ///< scene units from the scene's eye to the sheet; 0: not known
    bool scale_is_given = false; ///< by units_per_mm; else k follows from sheet_distance
};

inline Vec3 scene_from_sheet(const Placement& p, Vec3 v)
{
    return p.origin + v.x * p.x + v.y * p.y + v.z * p.z;
}

/// Inverse of scene_from_sheet.
Vec3 sheet_from_scene(const Placement& placement, Vec3 point);

/// Difference between the scene's eye and the viewer's eye (optics.md section 8).
struct Parallax {
    double factor = 1;         ///< K, 0 to 100: the scene's eye moves K mm per mm of the viewer's
    double scene_distance = 0; ///< d0, mm from the sheet to the scene's eye, > 0
};

/// Maps points of the scene to where a viewer at `viewing_distance` (mm, > 0) sees them, both in
/// the sheet frame (for a projection, the frame of the sheet's image).
inline Collineation relief_of(const Parallax& parallax, double viewing_distance)
{
    const double k = parallax.factor, d = parallax.scene_distance;
    return {1, k * viewing_distance / d, (1 - k) / d};
}

/// One integral camera, ready to render W x H pixels: immutable.
struct IntegralCamera {
    SheetOptics optics;
    Film film;
    Placement placement;
    LensMapping mapping = LensMapping::automatic;
    std::optional<Vec2> depth_range;
    int pixel_samples = 1, beam_samples = 1;
    bool pseudoscopic = false;
    /// Samples are spread by a tent two pixels and two lens cells wide, centred on pixel and pole,
    /// instead of uniformly over one pixel and one cell. That is a low-pass filter at the sheet's
    /// bandwidth: it removes detail that the sheet cannot show (Zwicker et al. 2006, with a tent in
    /// place of their ideal filter). Every sample goes through the lens of the pixel's centre, even
    /// if its film point belongs to a neighbour.
    bool display_prefilter = false;
    /// If set, the aperture is this lens or, for a lenticular sheet, this lens's image of the
    /// viewer's aperture; and `placement` is that of the image frame (projection.h).
    std::optional<ProjectionLens> projection = {};
    /// Empty: the scene's eye and the viewer's are one.
    std::optional<Parallax> parallax = {};
    Collineation relief = {}; ///< of `parallax`; else the identity

    /// Height (mm) of a lenticular sheet's slit at a point of the aperture plane; 0 for other
    /// sheets.
    double slit_height(Vec2 aperture_point) const;
};

/// mm from the sheet, or its projected image, to the viewer's eye.
double viewer_distance(const IntegralCamera& camera);

/// mm from the sheet to the scene's eye: the viewing distance unless
/// CameraParameters::viewing_distance is given.
double scene_viewing_distance(const ViewFrame& view, double units_per_mm);

/// Builds the camera for a frame of width x height pixels. Throws std::invalid_argument, with a
/// sentence for the user, if the parameters cannot work.
IntegralCamera make_camera(const CameraParameters& parameters, const ViewFrame& view, int width,
                           int height);

/// The place where the viewer sees a point of the scene, mm in the sheet frame; z is infinite if
/// the relief maps the point to infinity or beyond it.
Vec3 seen_from_scene(const IntegralCamera& camera, Vec3 scene_point);

/// Inverse: the point of the scene that the viewer sees at `seen`. Empty if there is none, because
/// the viewer sees the scene's infinity at that depth or nearer.
std::optional<Vec3> scene_from_seen(const IntegralCamera& camera, Vec3 seen);

/// A line of sight in scene coordinates: from its end on the viewer's side into the scene.
struct SightLine {
    Vec3 origin, direction; ///< direction: unit
    double length = 0;      ///< range of the camera, scene units; 0: to infinity
};

/// Step 6 of optics.md section 3: the one ray to trace, from the aperture (or depth_range's front)
/// through the lens to infinity (or depth_range's back), which returns what the viewer would see.
/// pseudoscopic: starts at the sheet, as Lippmann's capture sees nothing on the viewer's side.
SightLine sight_line(const IntegralCamera& camera, const BeamRay& ray);

/// A parallelogram in the scene: centre + a*half_x + b*half_y, a and b in [-1, 1].
struct StartRegion {
    Vec3 centre, half_x, half_y;
};

/// A region that contains the origins of all sight lines of the frame. Empty for projections,
/// hybrid, full and the display prefilter, whose rays may cross the aperture's plane anywhere.
std::optional<StartRegion> start_region(const IntegralCamera& camera);

} // namespace integral

#endif
