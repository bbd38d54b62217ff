// SPDX-License-Identifier: AGPL-3.0-or-later
// Figures of multi-view images, in closed form (thesis 5.2 and 6.1). Lengths in mm.
#ifndef INTEGRAL_LABORATORY_VIEW_FIGURES_H
#define INTEGRAL_LABORATORY_VIEW_FIGURES_H

#include "integral/frame/frame_metadata.h"

#include <optional>

namespace integral {

/// The place at which the picture of a converging (toed-in) camera shows the point `place` of the
/// sheet; a camera parallel to the sheet shows it at `place`. The camera is `distance` in front of
/// the sheet and `aside` to the right of its middle, looks at the middle, and has the field of view
/// of a camera in front of the middle.
Vec2 converging_place(Vec2 place, double aside, double distance);

/// Depths in front of and behind the sheet at which the places where two eyes `step` apart see a
/// point are one lens apart: deeper points jump by more than a lens from view to view.
struct LensApart {
    double front;
    std::optional<double> back; ///< nothing: all depths are in range
};
LensApart lens_apart(double pitch, double step, double distance);

/// The part of the sheet that shows a neighbouring view, on average over the eyes in a view's own
/// part of the zone. Pixels are `pixel` views wide (at most 1), with middles anywhere in a view.
double mean_crosstalk(double pixel);

/// The least distance from which an eye sees one view on the whole width, if views are interleaved
/// for eyes at infinity (figure 5-1): width x thickness x views / pitch, which is 1.82 m for the
/// thesis's 125 mm and 6 views.
double one_view_distance(const LensSheet& sheet, double width, int views);

/// The closed forms of a multi-view image.
struct ViewFigures {
    double distance, zone;           ///< of the eyes
    double step;                     ///< between the places of views in the eyes' plane: the
                                     ///< flipping period
    double pixel_step;               ///< the same for neighbouring pixels of a lens
    double pixels_per_lens;          ///
    LensApart depth;                 ///< for eyes `step` apart
    std::optional<double> crosstalk; ///< mean_crosstalk; nothing where pixels are wider than views
    Vec2 keystone; ///< distance between the places at which the outermost converging cameras show
                   ///< the picture's corner, across and up; parallel ones show it at one place
    std::optional<double> moire; ///< moire_pitch; nothing: the whole sheet flips at once
    double one_view_from;        ///< one_view_distance
};

/// For a lenticular sheet and `views` > 0 over its viewing zone.
ViewFigures view_figures(const FrameMetadata& geometry, int views);

} // namespace integral

#endif
