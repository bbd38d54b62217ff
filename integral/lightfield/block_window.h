// SPDX-License-Identifier: AGPL-3.0-or-later
// A copy of what is known of a block's pixels and of those around the block. Walking through it is
// quick: a pixel's neighbours need not be decoded again for each pixel, and the frame has no end.
#ifndef INTEGRAL_LIGHTFIELD_BLOCK_WINDOW_H
#define INTEGRAL_LIGHTFIELD_BLOCK_WINDOW_H

#include "integral/lightfield/pass_schedule.h"

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

    /// Calls visit(i, j, value) for the pixels at most `reach` away from (x, y), itself included;
    /// (i, j): the way to them.
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

} // namespace integral

#endif
