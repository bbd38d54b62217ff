// SPDX-License-Identifier: AGPL-3.0-or-later
// The views that depth is measured in: pictures of one scene from eyes on one plane, all with the
// same image plane, and how far apart in them a point of the scene stands.
//
// Disparity is the unit of all measuring: by how many pixels (of a view, across) a point of the
// scene moves to the left from one view to the next on the right. It is 0 in the image plane, which
// of a frame is its sheet, greater than 0 in front of it and less behind it.
//
// Views of eyes above each other (of lenses that lie across, or a single column) are turned by a
// quarter, clockwise, and so become views side by side: their right is up in the scene.
#ifndef INTEGRAL_DEPTH_VIEW_SET_H
#define INTEGRAL_DEPTH_VIEW_SET_H

#include "integral/base/parallel.h"
#include "integral/lightfield/frame.h"
#include "integral/lightfield/view_grid.h"

#include <array>
#include <optional>
#include <vector>

namespace integral {

/// R, G and B as planes, row by row from the top left: stored values; 1 is full scale.
using ColourPlanes = std::array<std::vector<float>, 3>;

/// A view to compare with others.
struct DepthView {
    Vec2 shift; ///< pixels to the right and down that a disparity of 1 moves a point, from where
                ///< the middle view has it
    ColourPlanes channels;
    std::vector<float> lit; ///< 1, or 0 for a pixel without light; empty: all have some
};

/// How disparities become millimetres: a point z mm behind the image plane has the disparity
/// -ratio z / (distance + z).
struct DepthScale {
    double distance = 0; ///< from the eyes to the image plane, mm; > 0
    double ratio = 1;    ///< distance between neighbouring eyes by a pixel's width in that plane

    double disparity(double mm) const { return -ratio * mm / (distance + mm); }
    /// Inverse; infinite where the lines of sight do not meet.
    double mm(double disparity) const;
};

/// Where the pixels of the views lie in the image plane: the middle of the top left one, and the
/// steps to the next on the right and to the next below. In mm, x to the right and y up; for views
/// of unknown size, in pixels.
struct PixelPlaces {
    Vec2 first, right{1, 0}, down{0, -1};
    Vec2 at(double column, double row) const { return first + column * right + row * down; }
    Vec2 pixel_at(Vec2 point) const; ///< inverse: column and row, whole in the middle of a pixel
};

struct ViewSet {
    int width = 0, height = 0; ///< pixels of each view
    DepthView middle;          ///< whose depth is measured; its shift is 0
    std::vector<DepthView> others;
    ColourPlanes colours; ///< of the middle view before soften()
    PixelPlaces places;
    std::optional<DepthScale> scale; ///< nothing: millimetres are not known
    Vec2 eye; ///< of the middle view, mm; not 0 in a grid with no eye in its middle
    bool turned = false; ///< clockwise by a quarter

    /// Pixels of the views before they were turned, and the index of a pixel there.
    int upright_width() const { return turned ? height : width; }
    int upright_height() const { return turned ? width : height; }
    std::size_t upright_pixel(int x, int y) const
    {
        return turned ? std::size_t(width - 1 - x) * height + y : std::size_t(y) * width + x;
    }
    std::size_t pixels() const { return std::size_t(width) * height; }
    bool is_lit(std::size_t pixel) const { return middle.lit.empty() || middle.lit[pixel] > 0; }
};

/// Softens all views a little, each pixel with its neighbours that are lit, so that they can be
/// compared between their pixels too: an edge that is a pixel wide differs there from itself. Keeps
/// `colours` as they were.
void soften(ViewSet& views, int threads);

/// Where views were taken from, for ones that do not carry it. In mm.
struct ViewEyes {
    Vec2 spacing;        ///< between neighbouring eyes, across and up
    double distance = 0; ///< from the eyes to the plane without parallax
    double width = 0;    ///< of a view in that plane
};

/// The views of a grid of eyes as a set; the middle one is that of column columns / 2 and row
/// rows / 2. `eyes`: if nothing, the spacing is taken as the same across and up, and millimetres
/// are not known. `shape`: width by height of a view as it is to be seen; nothing: that of its
/// pixels. Throws std::invalid_argument if the views differ in size or are fewer than 3.
ViewSet view_set(const std::vector<Image>& views, ViewGrid grid,
                 const std::optional<ViewEyes>& eyes, std::optional<double> shape = std::nullopt);

/// What eyes see of a frame that are spread over its viewing zone, as far apart as neighbouring
/// pixels of the film show (farther where these are more than 256 a lens): a column for each lens
/// and a row for each row of lenses, or (lenticular sheets) of the film; turned where lenses lie
/// across. Each value is interpolated between the pixels of its lens, never across the border of
/// two. Throws std::invalid_argument for a frame with fewer than 3 pixels a lens, or smaller than a
/// lens; Interrupted if `progress` stops the work.
ViewSet view_set(const Frame& frame, int threads, const Progress& progress);

} // namespace integral

#endif
