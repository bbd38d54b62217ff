// SPDX-License-Identifier: AGPL-3.0-or-later
// What a sheet, a film and a viewer give, before anything is rendered: the thesis's formulas,
// each with its equation number. Lengths in mm, angles in degrees, resolutions in line pairs
// per mm (the thesis has them per inch).
#ifndef INTEGRAL_LIGHTFIELD_SHEET_FIGURES_H
#define INTEGRAL_LIGHTFIELD_SHEET_FIGURES_H

#include "integral/optics/aperture.h"

#include <optional>

namespace integral {

/// (2-1): the angle between the axis and the ray to a lens's edge, arcsin(n sin(atan(p/2t)));
/// twice this is the viewing angle. Empty: such rays are totally reflected, which limits the view.
std::optional<double> greatest_angle(const LensSheet& sheet);

/// Two such sheets back to back, their lenses' foci in common (thesis 2.4.1), send light that meets
/// the axis at an angle out through the lens opposite as far as it gets there; the rest comes out
/// in a side lobe. Returns the angle at which half of the light does, arcsin(n sin(atan(p/4t))):
/// any angle loses some, and from greatest_angle on all. Empty: it is totally reflected.
std::optional<double> half_lost_angle(const LensSheet& sheet);

/// The focal length, mm in the sheet's medium, of lenses in those foci's plane that image each lens
/// onto the one opposite (figure 2-11). With them no light is lost up to greatest_angle.
double field_lens_focus(const LensSheet& sheet);

/// Two tiers (thesis 2.4.2, figure 2-13): before the micro-lenses a macro-lens makes an image of
/// the scene, compressed in depth. Returns how deep the image of everything from `nearest` mm
/// before the lens to infinity is: F^2/(nearest - F), by the ideal thin lens; nearest > F.
constexpr double nearest_in_two_tiers = 300; // mm, in the thesis
double macro_lens_depth(double focal_length, double nearest);

/// Its inverse: from where to infinity an image that is so deep shows, F + F^2/depth; depth > 0.
double macro_lens_nearest(double focal_length, double depth);

/// (3-8): micro-image width by the simple pinhole, t w / d.
double pinhole_spread(const LensSheet& sheet, double distance, double width);

/// (3-5), paraxially: the distance in mm at which an aperture of the given width fills a lens's
/// cell, W t/(n cell); all in mm.
double filling_distance(const LensSheet& sheet, double width, double cell);

/// (4-1): how many pixels of each lens an eye's pupil sees from a distance; `pixel` is their pitch.
double pixels_seen(const LensSheet& sheet, double pixel, double pupil, double distance);

/// (4-4): the angle that a pixel covers, arcsin(n sin(atan(pixel/t))). Empty: totally reflected.
std::optional<double> pixel_angle(const LensSheet& sheet, double pixel);

/// (4-5): what a pixel of that angle, centred on its lens's axis, covers at a distance:
/// 2 distance tan(angle/2).
double pixel_spread(double angle, double distance);

/// (4-6): resolution of the pixelated image of an object at a depth (distance from the sheet, > 0).
/// Empty where the formula has no value: n^2 p^2 > 4t^2 + p^2.
std::optional<double> depth_resolution(const LensSheet& sheet, double pixel, double depth);

/// The depth budget: the depth on either side of the sheet up to which (4-6) is at least the
/// sheet's own resolution, 1/(2p). Empty where (4-6) has no value.
std::optional<double> depth_budget(const LensSheet& sheet, double pixel);

/// (4-7): resolution by the lenses alone, for an observer at `viewing` and an object `object`
/// in front of the sheet (negative: behind); object < viewing.
double observer_resolution(double pitch, double viewing, double object);

/// (5-1): the least distance from which the whole width of a sheet shows the same pixel of every
/// lens, width t / pixel.
double discrete_view_distance(const LensSheet& sheet, double pixel, double width);

/// The pitch at which lenses of a sheet's thickness and index image an eye at `distance` on the
/// film, a little more than the lenses' own: the mean from the axis to a lens `place` mm from it,
/// p (1 + t/sqrt(n^2 d^2 + (n^2 - 1) place^2)) (optics.md section 4).
double visual_pitch(double pitch, const LensSheet& sheet, double distance, double place = 0);

/// Inverse of visual_pitch: the lenses' own pitch.
double pitch_of_visual(double visual, const LensSheet& sheet, double distance, double place = 0);

/// The period on the sheet of the pattern in which an eye sees the lenses change from one pixel
/// to the next (thesis 5.3): p / |N - round(N)| for N pixels per visual pitch.
/// Empty: N is whole, and the whole sheet changes at once.
std::optional<double> moire_pitch(double pitch, const LensSheet& sheet, double pixel,
                                  double distance);

/// Between which distances an eye before the picture's middle sees all of it in one viewing zone.
struct WholePicture {
    double nearest;                 ///< mm
    std::optional<double> farthest; ///< mm; empty: however far
};

/// For a picture `width` wide that is made to be seen from `distance`, where its zone is `zone`
/// wide; all > 0, mm. The line of sight from the eye through the picture's edge has to meet the
/// zone.
WholePicture whole_picture(double distance, double zone, double width);

} // namespace integral

#endif
