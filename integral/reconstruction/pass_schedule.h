// SPDX-License-Identifier: AGPL-3.0-or-later
// Orders the work of threads on the blocks of a picture in several passes. Each pass needs the
// results of the pass before it in and around its own block. The passes follow each other down the
// picture at a distance of a few rows of blocks, so that the first rows are finished long before
// the last are begun, and no thread waits for others at the end of a pass.
#ifndef INTEGRAL_RECONSTRUCTION_PASS_SCHEDULE_H
#define INTEGRAL_RECONSTRUCTION_PASS_SCHEDULE_H

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <optional>
#include <vector>

namespace integral {

/// Width and height of a renderer's blocks, pixels, for a given Render_Block_Size: at least 4, as
/// in POV-Ray. The maximum is larger than any frame; a few times the maximum still fit in an int.
inline int block_side_of(int requested) { return std::clamp(requested, 4, 1 << 24); }

/// A part of a picture, in pixels; right and bottom are inclusive.
struct PictureBlock {
    int left = 0, top = 0, right = -1, bottom = -1;
};

/// One pass of a schedule.
struct SchedulePass {
    /// Whether the pass works on a row, for each row from the top of the area. In a block the pass
    /// works on all rows from the first such row to the last.
    std::vector<bool> rows;
    /// Number of rows above and below a block in which the pass before must have finished, if it
    /// works there at all; 0 for the first pass.
    int reach = 0;
};

/// Hands out the blocks of all passes in a fixed order. Thread-safe. The first pass waits
/// for the last one, so that few rows are in use at a time, whatever the height of the picture.
class PassSchedule {
public:
    struct Item {
        int pass = 0;
        PictureBlock block;
    };

    /// `area` is divided into blocks of `side` x `side` pixels from its top left.
    PassSchedule(PictureBlock area, int side, std::vector<SchedulePass> passes);
    PassSchedule(const PassSchedule&) = delete;

    /// The next item of work; nothing when all have been given out. An item's prerequisites have
    /// been given out before it.
    std::optional<Item> next();

    /// Whether all prerequisites of the item are finished. For an item of the first pass: whether
    /// the last pass is at most as far behind as the order of the items has it.
    bool is_ready(const Item& item) const;

    /// Reports that the item is finished.
    void finish(const Item& item);

    /// The first row of the picture whose data a pass still needs: the top of its first unfinished
    /// block minus its reach. INT_MAX: the pass has finished.
    int first_needed(int pass) const;

private:
    int row_of(const Item& item) const { return (item.block.top - area_.top) / side_; }
    int blocks_around(int pass) const
    {
        return (passes_[std::size_t(pass)].reach + side_ - 1) / side_;
    }
    void append_row(int pass, int row);
    int first_unfinished(int pass) const; ///< as a row of blocks

    PictureBlock area_;
    int side_, rows_, columns_;
    std::vector<SchedulePass> passes_;
    std::vector<Item> items_;
    std::vector<std::vector<std::atomic<int>>> left_; ///< blocks not finished, [pass][row of
                                                      ///< blocks]
    /// For each pass, a row of blocks: all rows above it are finished. Set by first_unfinished.
    mutable std::vector<std::atomic<int>> finished_above_;
    int ahead_ = 0; ///< rows of blocks between the first and the last pass in the order
    std::atomic<std::size_t> given_{0};
};

} // namespace integral

#endif
