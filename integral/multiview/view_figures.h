// SPDX-License-Identifier: AGPL-3.0-or-later
// What multi-view images are subject to, in closed form (thesis 5.2 and 6.1). Lengths in mm.
#ifndef INTEGRAL_MULTIVIEW_VIEW_FIGURES_H
#define INTEGRAL_MULTIVIEW_VIEW_FIGURES_H

#include "integral/lightfield/frame_metadata.h"

#include <optional>

namespace integral {

/// Where the picture of a converging (toed-in) camera shows a point of the sheet, by its place on
/// the sheet; a camera in parallel with the sheet shows it at its place. The camera is `distance`
/// before the sheet and `aside` to the right of its middle, looks at the middle, and has the field
/// of view of a camera before the middle.
Vec2 converging_place(Vec2 place, double aside, double distance);

/// Depths in front of and behind the sheet at which eyes `step` apart see a point one lens apart:
/// what is deeper jumps by more than a lens from view to view.
struct LensApart {
    double front;
    std::optional<double> back; ///< nothing: all depths are in range
};
LensApart lens_apart(double pitch, double step, double distance);

/// The part of the sheet that shows a neighbouring view to an eye within a view's own part of the
/// zone, on average over that part: a pixel is `pixel` views wide (at most 1) and has its middle
/// anywhere.
double mean_crosstalk(double pixel);

/// The least distance from which views that are interleaved for eyes at infinity (figure 5-1) are
/// seen one at a time on the whole width: width t N/p, which is 1.82 m for the thesis's 125 mm and
/// 6 views.
double one_view_distance(const LensSheet& sheet, double width, int views);

/// The closed forms of a multi-view image.
struct ViewFigures {
    double distance, zone;           ///< of the eyes
    double step;                     ///< from view to view at the eyes: the flipping period
    double pixel_step;               ///< from pixel to pixel of a lens, likewise
    double pixels_per_lens;          ///
    LensApart depth;                 ///< by views
    std::optional<double> crosstalk; ///< mean_crosstalk; nothing where pixels are wider than views
    Vec2 keystone; ///< how far apart the outermost converging cameras show the picture's corner,
                   ///< across and up; parallel ones show it at one place
    std::optional<double> moire; ///< moire_pitch; nothing: the whole sheet flips at once
    double one_view_from;        ///< one_view_distance
};

/// For a lenticular sheet and `views` > 0 over its viewing zone.
ViewFigures view_figures(const FrameMetadata& geometry, int views);

} // namespace integral

#endif
