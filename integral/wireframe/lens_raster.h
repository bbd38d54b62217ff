// SPDX-License-Identifier: AGPL-3.0-or-later
// Stores the pixels behind one lens, with a depth for each: the nearest thing drawn stays.
#ifndef INTEGRAL_WIREFRAME_LENS_RASTER_H
#define INTEGRAL_WIREFRAME_LENS_RASTER_H

#include "integral/frame/image.h"
#include "integral/wireframe/lens_pixels.h"

#include <algorithm>
#include <vector>

namespace integral {

/// Corner of a thing to draw: a place on the film, the scene point's z (mm) and linear light.
struct FilmCorner {
    Vec2 pixel; ///< continuous pixel coordinates
    double depth;
    Colour colour;
};

/// A rectangle of pixels: columns [left, right), rows [top, bottom).
struct PixelBox {
    int left, top, right, bottom;
};

/// Pixels of one lens. A place is an index into the raster, whose rows have equal numbers of
/// columns. Rows of a strongly slanted lens begin at the lens's first pixel in that row, so that
/// such a lens takes no more memory than an upright lens. A border surrounds the rows. Places that
/// are not pixels of the lens have the depth `blocked`, in front of everything.
class LensRaster {
public:
    /// Begins an empty drawing on the pixels of a lens's runs. Reuses its memory.
    void begin(const LensRun* begin, const LensRun* end);

    /// Empties the drawing.
    void clear() { depth_ = empty_; }

    /// Draws on the lens's pixels only.
    void draw_point(const FilmCorner& at);
    /// Draws a straight line, one pixel wide, with both ends.
    void draw_line(const FilmCorner& from, const FilmCorner& to);
    /// Fills the lens's pixels in one row, or in all rows.
    void fill_row(int y, double depth, Colour colour);
    void fill(double depth, Colour colour);

    const PixelBox& box() const { return box_; }
    /// Number of places. for_each_pixel_in calls visit(index, x, y) for each pixel of the lens in
    /// `box`, with an index from 0 to size() - 1.
    std::size_t size() const { return depth_.size(); }
    template <class Visit> void for_each_pixel_in(const PixelBox& box, Visit visit) const
    {
        const int top = std::max(box.top, box_.top), bottom = std::min(box.bottom, box_.bottom);
        for (int y = top; y < bottom; ++y) {
            const int left = left_[std::size_t(y - box_.top)];
            const int from = std::max(left, box.left), to = std::min(left + columns_, box.right);
            for (int x = from; x < to; ++x) {
                const std::size_t index = place(x - left, y - box_.top);
                if (empty_[index] == nothing)
                    visit(index, x, y);
            }
        }
    }

    /// Whether all rows begin at box().left. Then a pixel's index is place(column, row), counted
    /// from the box's corner; -1 and columns() or rows() are the border.
    bool is_upright() const { return upright_; }
    int columns() const { return columns_; }
    int rows() const { return box_.bottom - box_.top; }
    int stride() const { return columns_ + 2; }
    std::size_t place(int column, int row) const
    {
        return std::size_t(row + 1) * std::size_t(columns_ + 2) + std::size_t(column + 1);
    }

    /// A blocked place that belongs to no pixel.
    int nowhere() const { return int(size()) - 1; }

    /// Depths of the drawing at all places; they change as things are drawn.
    const float* depths() const { return depth_.data(); }
    /// Whether a thing at this depth is in front of the drawing at a place.
    bool is_seen_at(std::size_t index, float depth) const { return depth < depth_[index]; }
    void draw_at(std::size_t index, float depth, Colour colour)
    {
        if (is_seen_at(index, depth)) {
            depth_[index] = depth;
            colour_[index] = colour;
        }
    }
    bool is_drawn(std::size_t index) const
    {
        return depth_[index] < nothing && empty_[index] == nothing;
    }
    Colour colour(std::size_t index) const { return colour_[index]; }

private:
    static constexpr float nothing = 3e38f, blocked = -3e38f;
    bool is_in_box(Vec2 pixel) const
    {
        return pixel.x >= box_.left && pixel.x < box_.right && pixel.y >= box_.top &&
               pixel.y < box_.bottom;
    }
    /// Index of a pixel; 0, a place on the border, if the raster lacks the pixel.
    std::size_t index_at(int x, int y) const
    {
        if (y < box_.top || y >= box_.bottom)
            return 0;
        const int column = x - left_[std::size_t(y - box_.top)];
        return column >= 0 && column < columns_ ? place(column, y - box_.top) : 0;
    }

    PixelBox box_{};
    int columns_ = 0;
    bool upright_ = true;
    std::vector<int> left_;            ///< first pixel of each row
    std::vector<float> depth_, empty_; ///< of each place: in the drawing, and after clear()
    std::vector<Colour> colour_;
};

} // namespace integral

#endif
