// SPDX-License-Identifier: AGPL-3.0-or-later
// The rows of a picture on which the passes of anti-aliasing work, so that those rows that count
// are as they are in the whole frame.
#ifndef INTEGRAL_LIGHTFIELD_PASS_ROWS_H
#define INTEGRAL_LIGHTFIELD_PASS_ROWS_H

#include "integral/lightfield/pass_schedule.h"
#include "integral/optics/camera.h"

#include <vector>

namespace integral {

/// How many rows away the passes look.
class PassRows {
public:
    /// `block_side`: refinement and reconstruction work on whole blocks of so many rows, since a
    /// pixel can cause its neighbours to be refined, and all of a block's pixels tell how many show
    /// a signal of their own. `reconstructs`: whether the frame is reconstructed and filtered, too.
    PassRows(const LensSheet& sheet, const Film& film, int block_side, bool reconstructs);

    /// From a refined pixel to first samples; from a pixel's layers to refined pixels; from a
    /// reconstructed pixel to layers; from a finished pixel to reconstructed ones. The last three
    /// are 0 if the frame is not reconstructed.
    int looked_at() const { return looked_at_; }
    int estimated_from() const { return estimated_from_; }
    int reconstructed_from() const { return reconstructed_from_; }
    int filtered_from() const { return filtered_from_; }

    /// From a row that counts to samples, at most: whole blocks, and the neighbours of these.
    int sampled_from() const { return refined_from() + looked_at_; }
    /// The same, to refined pixels.
    int refined_from() const;

    /// From a finished row to further samples that are still needed.
    int kept_from() const;

    /// All passes: first samples, refinement, layers and reconstruction where the frame is
    /// reconstructed, and the last one, which finishes the rows that are `wanted`. `counting`:
    /// those of them that must be as in the whole frame. Blocks begin at the first row.
    std::vector<SchedulePass> passes(const std::vector<bool>& wanted,
                                     const std::vector<bool>& counting) const;

private:
    int whole_blocks(int rows) const { return (rows + side_ - 1) / side_ * side_; }
    std::vector<bool> of_blocks(const std::vector<bool>& rows) const;

    int side_;
    bool reconstructs_;
    int looked_at_, estimated_from_ = 0, reconstructed_from_ = 0, filtered_from_ = 0;
};

} // namespace integral

#endif
