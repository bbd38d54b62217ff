// SPDX-License-Identifier: AGPL-3.0-or-later
// Figures of a sheet, a film and a viewer before anything is rendered: the thesis's formulas, each
// with its equation number. Lengths in mm, angles in degrees, resolutions in line pairs per mm (the
// thesis has them per inch).
#ifndef INTEGRAL_SHEET_SHEET_FIGURES_H
#define INTEGRAL_SHEET_SHEET_FIGURES_H

#include "integral/optics/aperture.h"

#include <optional>

namespace integral {

/// (2-1): the angle between the axis and the ray to a lens's edge, arcsin(n sin(atan(p/2t))); the
/// viewing angle is twice this. Empty if such rays are totally reflected, which limits the view.
std::optional<double> greatest_angle(const LensSheet& sheet);

/// The angle to the axis at which two of these sheets back to back, with common foci (thesis
/// 2.4.1), lose half of the light: arcsin(n sin(atan(p/4t))). The opposite lens passes the light
/// that reaches it; all other light leaves in a side lobe. Some light is lost at any angle, and all
/// of it from greatest_angle on. Empty if light at that angle is totally reflected.
std::optional<double> half_lost_angle(const LensSheet& sheet);

/// The focal length, mm in the sheet's medium, of field lenses in the plane of the common foci (see
/// half_lost_angle) that image each lens onto the opposite lens (figure 2-11). With field lenses no
/// light is lost up to greatest_angle.
double field_lens_focus(const LensSheet& sheet);

/// Two tiers (thesis 2.4.2, figure 2-13): a macro-lens before the micro-lenses makes an image of
/// the scene, compressed in depth. Returns the depth of the image of everything from `nearest` mm
/// before the lens to infinity: F^2/(nearest - F), by the ideal thin lens; nearest > F.
constexpr double nearest_in_two_tiers = 300; // mm, in the thesis
double macro_lens_depth(double focal_length, double nearest);

/// Inverse of macro_lens_depth: the nearest distance for an image of that depth, F + F^2/depth;
/// depth > 0.
double macro_lens_nearest(double focal_length, double depth);

/// (3-8): micro-image width by the simple pinhole, t w / d.
double pinhole_spread(const LensSheet& sheet, double distance, double width);

/// (3-5), paraxially: the distance at which an aperture of the given width fills a lens's cell,
/// W t/(n cell); all in mm.
double filling_distance(const LensSheet& sheet, double width, double cell);

/// (4-1): the number of pixels of each lens that an eye's pupil sees from a distance; `pixel` is
/// their pitch.
double pixels_seen(const LensSheet& sheet, double pixel, double pupil, double distance);

/// (4-4): the angle covered by a pixel, arcsin(n sin(atan(pixel/t))). Empty if totally reflected.
std::optional<double> pixel_angle(const LensSheet& sheet, double pixel);

/// (4-5): the width that a pixel of that angle, centred on its lens's axis, covers at a distance:
/// 2 distance tan(angle/2).
double pixel_spread(double angle, double distance);

/// (4-6): resolution of the pixelated image of an object at a depth (distance from the sheet, > 0).
/// Empty if the formula has no value: n^2 p^2 > 4t^2 + p^2.
std::optional<double> depth_resolution(const LensSheet& sheet, double pixel, double depth);

/// The depth budget: the depth on either side of the sheet up to which (4-6) is at least the
/// sheet's own resolution, 1/(2p). Empty if (4-6) has no value.
std::optional<double> depth_budget(const LensSheet& sheet, double pixel);

/// (4-7): resolution of the lenses alone, for an observer at `viewing` and an object `object` in
/// front of the sheet (negative: behind); object < viewing.
double observer_resolution(double pitch, double viewing, double object);

/// (5-1): the least distance from which the whole width of a sheet shows the same pixel of every
/// lens: width * t/pixel.
double discrete_view_distance(const LensSheet& sheet, double pixel, double width);

/// The period on the sheet of the pattern in which an eye sees the lenses change from one pixel to
/// the next (thesis 5.3): p / |N - round(N)| for N pixels per visual pitch. Empty if N is whole:
/// then the whole sheet changes at once.
std::optional<double> moire_pitch(double pitch, const LensSheet& sheet, double pixel,
                                  double distance);

/// Range of distances at which an eye before the picture's middle sees all of it in one viewing
/// zone.
struct WholePicture {
    double nearest;                 ///< mm
    std::optional<double> farthest; ///< mm; empty: no limit
};

/// Range of the eye's distances from which a whole picture is seen: `width` wide, made for viewing
/// from `distance`, where the viewing zone is `zone` wide; all > 0, mm. The line from the picture's
/// edge to the eye, prolonged to `distance`, has to meet the zone there.
WholePicture whole_picture(double distance, double zone, double width);

} // namespace integral

#endif
