// SPDX-License-Identifier: AGPL-3.0-or-later
// Views for measuring depth: pictures of one scene from eyes on one plane, all with the same image
// plane, and the shift of scene points between them.
//
// All depth is measured as disparity: the number of pixels (of a view, across) by which a point of
// the scene moves to the left from one view to the next on the right. Disparity is 0 in the image
// plane (a frame's sheet), positive in front of that plane and negative behind it.
//
// Views of eyes above each other (of lenses that lie across, or a single column) are turned
// clockwise by 90 degrees to become views side by side: their right is up in the scene.
#ifndef INTEGRAL_DEPTH_VIEW_SET_H
#define INTEGRAL_DEPTH_VIEW_SET_H

#include "integral/base/parallel.h"
#include "integral/frame/frame.h"
#include "integral/frame/view_grid.h"

#include <array>
#include <optional>
#include <vector>

namespace integral {

/// R, G and B as planes, row by row from the top left: stored values; 1 is full scale.
using ColourPlanes = std::array<std::vector<float>, 3>;

/// A view to compare with others.
struct DepthView {
    Vec2 shift; ///< pixels to the right and down by which a disparity of 1 moves a point from its
                ///< place in the middle view
    ColourPlanes channels;
    std::vector<float> lit; ///< 1, or 0 for a pixel without light; empty: all have some
};

/// Relation of disparity and millimetres: a point z mm behind the image plane has the disparity
/// -ratio z / (distance + z).
struct DepthScale {
    double distance = 0; ///< from the eyes to the image plane, mm; > 0
    double ratio = 1;    ///< distance between neighbouring eyes / a pixel's width in that plane

    double disparity(double mm) const { return -ratio * mm / (distance + mm); }
    /// Inverse; infinite where the lines of sight do not meet.
    double mm(double disparity) const;
};

/// Places of the views' pixels in the image plane: the middle of the top left pixel, and the steps
/// to the next one on the right and the next one below. In mm, x to the right and y up; in pixels
/// for views of unknown size.
struct PixelPlaces {
    Vec2 first, right{1, 0}, down{0, -1};
    Vec2 at(double column, double row) const { return first + column * right + row * down; }
    /// Inverse: column and row, whole at pixel middles.
    Vec2 pixel_at(Vec2 point) const
    {
        const Vec2 off = point - first;
        const double area = right.x * down.y - right.y * down.x;
        return {(off.x * down.y - off.y * down.x) / area,
                (right.x * off.y - right.y * off.x) / area};
    }
};

struct ViewSet {
    int width = 0, height = 0; ///< pixels of each view
    DepthView middle;          ///< whose depth is measured; its shift is 0
    std::vector<DepthView> others;
    ColourPlanes colours; ///< of the middle view before soften()
    PixelPlaces places;
    std::optional<DepthScale> scale; ///< nothing: millimetres are not known
    Vec2 eye;            ///< of the middle view, mm; not 0 in a grid with no eye in its middle
    bool turned = false; ///< clockwise by 90 degrees

    /// Size of the views before they were turned, and the index of pixel (x, y) there.
    int upright_width() const { return turned ? height : width; }
    int upright_height() const { return turned ? width : height; }
    std::size_t upright_pixel(int x, int y) const
    {
        return turned ? std::size_t(width - 1 - x) * height + y : std::size_t(y) * width + x;
    }
    std::size_t pixels() const { return std::size_t(width) * height; }
    bool is_lit(std::size_t pixel) const { return middle.lit.empty() || middle.lit[pixel] > 0; }
};

/// Softens all views a little: mixes each pixel with its lit neighbours. Then views can be compared
/// between their pixels too; without it, an edge one pixel wide would not match the same edge in
/// another view. `colours` stay unsoftened.
void soften(ViewSet& views, int threads);

/// Eyes of views, for files that do not contain them. In mm.
struct ViewEyes {
    Vec2 spacing;        ///< between neighbouring eyes, across and up
    double distance = 0; ///< from the eyes to the plane without parallax
    double width = 0;    ///< of a view in that plane
};

/// Place (mm) of a grid's middle eye, in column columns / 2 and row rows / 2, from the middle of
/// all eyes: not 0 where a number is even.
Vec2 middle_eye(ViewGrid grid, Vec2 spacing);

/// Makes a set from the views of a grid of eyes; the middle view is middle_eye's. Without `eyes`,
/// the spacing is the same across and up, and millimetres are not known. `shape`: displayed width /
/// height of a view; nothing: pixels are square. Throws std::invalid_argument if the views differ
/// in size or are fewer than 3.
ViewSet view_set(const std::vector<Image>& views, ViewGrid grid,
                 const std::optional<ViewEyes>& eyes, std::optional<double> shape = std::nullopt);

/// The views of a frame from eyes spread over its viewing zone, as far apart as the images of
/// neighbouring film pixels in the eyes' plane (farther if a lens has more than 256 of these). A
/// view has a column for each lens, and a row for each row of lenses or (lenticular sheets) of the
/// film; it is turned if the lenses lie across. Each value is interpolated between the pixels of
/// its lens, never across the border of two lenses. Throws std::invalid_argument for a frame with
/// fewer than 3 pixels a lens, or smaller than a lens; Interrupted if `progress` stops the work.
ViewSet view_set(const Frame& frame, int threads, const Progress& progress);

} // namespace integral

#endif
