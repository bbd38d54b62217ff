// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares one spherical lens of a sheet, traced ray by ray (LensModel::full), with the pole ray of
// the extended pinhole: figure 3-26 of the thesis, and the difference of the two models from the
// lens's axis to its margin.
//
// The lens is the one on the sheet's axis, without slant. All positions are along x: across a
// lenticular lens, or along a row of other lenses. All points of the lens's cell have equal weight,
// as in a render; the falloff with the cosines of the angles, which a real film would record, is
// left out. Lengths in mm, angles in degrees.
#ifndef INTEGRAL_SAMPLING_LENS_PROFILE_H
#define INTEGRAL_SAMPLING_LENS_PROFILE_H

#include "integral/optics/beam.h"

#include <optional>
#include <vector>

namespace integral {

/// Width on the film of a lens's image of a bright slit. Aberration blurs the image's edges, so
/// each width is measured at a fraction of the greatest intensity.
struct ImageWidth {
    double at_half = 0;  ///< at 1/2: the apparent width
    double at_most = 0;  ///< at 1/10: contains nearly all the light
    double at_least = 0; ///< at 9/10: the part that is nearly fully lit
};

/// The experiment of thesis 3.5.3: the lens images a long slit, `width` wide at `distance` and with
/// a diffuse light behind it, on the film. The intensity at a film point is the fraction of the
/// lens's cell through which the point sees the slit. `points` >= 2: sample points across the cell,
/// and along it too unless the lens is lenticular. Nothing if the lens has no spherical surface
/// (has_surface), or if no light from the slit reaches the film.
std::optional<ImageWidth> full_image_width(const LensSheet& sheet, double distance, double width,
                                           int points);

/// The directions in which a film point's light leaves the lens by the full model, compared with
/// the point's pole ray. A ray's angle is measured between its projection on the x-z plane and the
/// sheet's axis; it is > 0 on the side opposite to the film point.
struct BeamDirection {
    double film = 0;             ///< the film point's distance from the lens's axis, mm
    double pole = 0;             ///< angle of the pole ray (extended pinhole)
    double mean = 0;             ///< mean difference between the rays' angles and `pole`
    double spread = 0;           ///< standard deviation of these differences
    double lower = 0, upper = 0; ///< their 1st and 99th percentile
    double share = 0; ///< fraction of the cell's points through which light leaves the lens; at the
                      ///< other points the light is totally reflected

    /// Root mean square difference between the rays' angles and the pole ray's.
    double error() const { return std::hypot(mean, spread); }
};

/// `points` as for full_image_width. Nothing if the lens has no spherical surface, or if the pole
/// ray or all the light is totally reflected.
std::optional<BeamDirection> full_beam_direction(const LensSheet& sheet, double film, int points);

} // namespace integral

#endif
