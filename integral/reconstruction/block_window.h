// SPDX-License-Identifier: AGPL-3.0-or-later
// Copies the data of a block's pixels and the pixels around it. Loops over neighbours are fast in
// this copy: the data are decoded once per pixel, and the frame's edges need no checks.
#ifndef INTEGRAL_RECONSTRUCTION_BLOCK_WINDOW_H
#define INTEGRAL_RECONSTRUCTION_BLOCK_WINDOW_H

#include "integral/reconstruction/light_field_image.h"
#include "integral/reconstruction/pass_schedule.h"

#include <cstddef>
#include <vector>

namespace integral {

template <class Value> class BlockWindow {
public:
    /// Makes room for a block and the pixels at most `margin` away. All values are Value().
    void begin(const PictureBlock& block, int margin)
    {
        pixels_ = {block.left - margin, block.top - margin, block.right + margin,
                   block.bottom + margin};
        width_ = pixels_.right - pixels_.left + 1;
        values_.assign(std::size_t(width_) * (pixels_.bottom - pixels_.top + 1), Value());
    }

    /// The pixels for which there is room; some may lie outside the frame.
    const PictureBlock& pixels() const { return pixels_; }

    Value& at(int x, int y) { return values_[index(x, y)]; }
    const Value& at(int x, int y) const { return values_[index(x, y)]; }

    /// Calls visit(i, j, value) for each pixel (x + i, y + j) with i and j from -reach to reach.
    template <int reach, class Visit> void for_each_around(int x, int y, Visit visit) const
    {
        const Value* row = &values_[index(x, y - reach)];
        for (int j = -reach; j <= reach; ++j, row += width_)
            for (int i = -reach; i <= reach; ++i)
                visit(i, j, row[i]);
    }

private:
    std::size_t index(int x, int y) const
    {
        return std::size_t(y - pixels_.top) * width_ + (x - pixels_.left);
    }

    PictureBlock pixels_;
    int width_ = 0;
    std::vector<Value> values_;
};

/// Fills a window: for each pixel behind a lens, in the block or at most `margin` away from it,
/// sets value.lens to LightFieldImage::number_of the lens and calls set(x, y, value).
template <class Value, class Set>
void fill_behind_lenses(BlockWindow<Value>& window, const PictureBlock& block, int margin,
                        const LightFieldImage& first, Set set)
{
    window.begin(block, margin);
    const PictureBlock& all = window.pixels();
    for (int y = all.top; y <= all.bottom; ++y)
        for (int x = all.left; x <= all.right; ++x)
            if (const auto lens = first.lens(x, y)) {
                Value& value = window.at(x, y);
                value.lens = LightFieldImage::number_of(*lens);
                set(x, y, value);
            }
}

} // namespace integral

#endif
