// SPDX-License-Identifier: AGPL-3.0-or-later
// The pixels behind one lens, with a depth for each: what is nearest to the viewer stays.
#ifndef INTEGRAL_WIREFRAME_LENS_RASTER_H
#define INTEGRAL_WIREFRAME_LENS_RASTER_H

#include "integral/lightfield/image.h"
#include "integral/wireframe/lens_pixels.h"

#include <algorithm>
#include <vector>

namespace integral {

/// A corner of what is drawn: a place on the film, the scene point's z (mm) and linear light.
struct FilmCorner {
    Vec2 pixel; ///< continuous pixel coordinates
    double depth;
    Colour colour;
};

/// A rectangle of pixels: columns [left, right), rows [top, bottom).
struct PixelBox {
    int left, top, right, bottom;
};

class LensRaster {
public:
    /// Of a lens's runs, which must outlive it.
    LensRaster(const LensRun* begin, const LensRun* end);

    /// Nothing is drawn after this.
    void clear();

    /// Draws what lies on the lens's own pixels, and leaves the others as they are.
    void draw_point(const FilmCorner& at);
    /// A straight line, a pixel wide, both ends included.
    void draw_line(const FilmCorner& from, const FilmCorner& to);
    /// All of the lens's pixels in a row, or in every row.
    void fill_row(int y, double depth, Colour colour);
    void fill(double depth, Colour colour);

    const PixelBox& box() const { return box_; }
    /// Number of pixels, each of which visit(index, x, y) is called for. index is 0 to size() - 1.
    std::size_t size() const { return depth_.size(); }
    template <class Visit> void for_each_pixel_in(const PixelBox& box, Visit visit) const
    {
        const int top = std::max(box.top, box_.top), bottom = std::min(box.bottom, box_.bottom);
        if (top >= bottom)
            return;
        for (const LensRun* run = first_of_row(top); run != end_ && run->row < bottom; ++run) {
            const int from = std::max(run->first, box.left), to = std::min(run->end, box.right);
            for (int x = from; x < to; ++x)
                visit(index_of(*run, x), x, run->row);
        }
    }
    /// Whether something at this depth is in front of what is drawn at a pixel.
    bool is_seen_at(std::size_t index, double depth) const { return float(depth) < depth_[index]; }
    /// Draws at a pixel that for_each_pixel_in visits.
    void draw_at(std::size_t index, double depth, Colour colour)
    {
        if (is_seen_at(index, depth)) {
            depth_[index] = float(depth);
            colour_[index] = colour;
        }
    }
    bool is_drawn(std::size_t index) const { return depth_[index] < nothing; }
    Colour colour(std::size_t index) const { return colour_[index]; }

private:
    static constexpr float nothing = 3e38f;
    static constexpr std::size_t outside = SIZE_MAX;
    bool is_in_box(Vec2 pixel) const
    {
        return pixel.x >= box_.left && pixel.x < box_.right && pixel.y >= box_.top &&
               pixel.y < box_.bottom;
    }
    /// The index of a pixel; `outside` where it is not the lens's.
    std::size_t index_at(int x, int y) const
    {
        if (y >= box_.top && y < box_.bottom)
            for (const LensRun* run = first_of_row(y); run != end_ && run->row == y; ++run)
                if (x >= run->first && x < run->end)
                    return index_of(*run, x);
        return outside;
    }
    std::size_t index_of(const LensRun& run, int x) const
    {
        return offset_[std::size_t(&run - begin_)] + std::size_t(x - run.first);
    }
    /// The first run of row y or below it.
    const LensRun* first_of_row(int y) const
    {
        return begin_ + row_start_[std::size_t(y - box_.top)];
    }

    const LensRun *begin_, *end_;
    PixelBox box_{};
    std::vector<std::size_t> offset_;       ///< of each run's first pixel
    std::vector<std::ptrdiff_t> row_start_; ///< of each row of the box, and one more
    std::vector<float> depth_;
    std::vector<Colour> colour_;
};

} // namespace integral

#endif
