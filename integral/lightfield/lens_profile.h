// SPDX-License-Identifier: AGPL-3.0-or-later
// What one real, spherical lens of a sheet does, ray by ray (LensModel::full), beside the pole ray
// of the extended pinhole: figure 3-26 of the thesis, and the two models' difference from a lens's
// axis to its margin.
//
// The lens is the one on the sheet's axis, the sheet turned upright; everything is measured along
// x, across a lenticular lens and along a row of others. All points of the lens's cell count alike,
// as they do in a render: the falloff with the cosine of the angles, which a film would record, is
// left out. Lengths in mm, angles in degrees.
#ifndef INTEGRAL_LIGHTFIELD_LENS_PROFILE_H
#define INTEGRAL_LIGHTFIELD_LENS_PROFILE_H

#include "integral/optics/beam.h"

#include <optional>
#include <vector>

namespace integral {

/// Width on the film of a lens's image of a bright opening. The image's edges are blurred by the
/// lens's aberration, so that the width depends on the intensity at which it is measured, in parts
/// of the greatest.
struct ImageWidth {
    double at_half = 0;  ///< where a measurer would see the edges
    double at_most = 0;  ///< at 1/10: nearly all the light is in this
    double at_least = 0; ///< at 9/10: nearly fully lit
};

/// The experiment of thesis 3.5.3: a long slit `width` wide at `distance`, with a diffuse light
/// behind it, imaged by the lens on the film. The intensity at a film point is the share of the
/// lens's cell through which it sees the light. `points` >= 2 across the cell (and as many the
/// other way, but for a lenticular lens). Nothing where the lens has no spherical surface
/// (has_surface), or no light from the slit reaches the film.
std::optional<ImageWidth> full_image_width(const LensSheet& sheet, double distance, double width,
                                           int points);

/// The beam in which a film point's light leaves its lens, by the full model, against its pole ray.
/// The angles are those between a ray's projection on the x-z plane and the sheet's axis; > 0 to
/// the side opposite to the film point.
struct BeamDirection {
    double film = 0;             ///< where the film point is: mm from the lens's axis
    double pole = 0;             ///< angle of the pole ray: the extended pinhole
    double mean = 0;             ///< of the angles of the beam's rays less `pole`
    double spread = 0;           ///< their root mean square about `mean`
    double lower = 0, upper = 0; ///< all but the outermost hundredth of the rays on either side are
                                 ///< between these
    double share = 0; ///< of the cell's points through which light gets out; the rest is totally
                      ///< reflected

    /// Root mean square of the rays' angles less the pole ray's.
    double error() const { return std::hypot(mean, spread); }
};

/// `points` as above. Nothing where the lens has no spherical surface, or the pole ray or all the
/// light is totally reflected.
std::optional<BeamDirection> full_beam_direction(const LensSheet& sheet, double film, int points);

/// The thesis's sheets (Appendix E): 1.27 mm, lenticular, and the square 0.6, 1.124, 0.845 and
/// 0.625 mm.
std::vector<LensSheet> thesis_sheets();

} // namespace integral

#endif
