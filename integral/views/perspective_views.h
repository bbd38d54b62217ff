// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes a frame from perspective views: pictures from a grid of eyes, all with the sheet as their
// image plane.
#ifndef INTEGRAL_VIEWS_PERSPECTIVE_VIEWS_H
#define INTEGRAL_VIEWS_PERSPECTIVE_VIEWS_H

#include "integral/frame/picture_fit.h"
#include "integral/views/parallel_views.h"

namespace integral {

/// The frame with the given geometry that shows the views. Views are numbered as in ViewGrid and
/// have the same size and form. Each is a picture of the whole sheet, or lies on it as in
/// `picture`, taken from the eye at the centre of its part of the zone (EyeGrid). A film pixel, or
/// each of its subpixels, gets the colour of its ray: interpolated between the eyes around the
/// point where the ray meets the eyes' plane, and within their pictures at the point where the ray
/// leaves the sheet. Pixels that image nothing are black (transparent); bars next to the views are
/// black. `threads` and `progress` as in replay; returns nothing if `progress` stopped the work.
/// Throws std::invalid_argument if the views differ in size or form, or number not grid.count().
std::optional<Image> frame_from_eye_views(const std::vector<Image>& views,
                                          const FrameMetadata& metadata, ViewGrid grid,
                                          EyeGrid eyes, int threads = 0,
                                          const Progress& progress = {},
                                          const FittedPicture& picture = {});

/// Makes that frame some rows at a time.
class FrameOfPerspectives {
public:
    /// The views must outlive this. Throws as frame_from_eye_views does.
    FrameOfPerspectives(const std::vector<Image>& views, const FrameMetadata& metadata,
                        ViewGrid grid, EyeGrid eyes, const FittedPicture& picture = {});
    ~FrameOfPerspectives();

    /// Draws rows as FrameOfViews::draw does.
    bool draw(int first, Image& band, int threads, const Progress& progress) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace integral

#endif
