// SPDX-License-Identifier: AGPL-3.0-or-later
// Determines the rows on which the passes of anti-aliasing work, so that the requested rows come
// out as in the whole frame.
#ifndef INTEGRAL_RECONSTRUCTION_PASS_ROWS_H
#define INTEGRAL_RECONSTRUCTION_PASS_ROWS_H

#include "integral/optics/camera.h"
#include "integral/reconstruction/pass_schedule.h"
#include "integral/frame/quilt_geometry.h"

#include <vector>

namespace integral {

/// Margins of the passes, in rows.
class PassRows {
public:
    /// `block_side`: number of rows in a block. Refinement and reconstruction work on whole blocks,
    /// since a pixel can cause its neighbours to be refined, and since reconstruction counts the
    /// pixels of a block that show a signal (signal_and_noise.h). `reconstructs`: whether the frame
    /// is also reconstructed and filtered.
    PassRows(const LensSheet& sheet, const Film& film, int block_side, bool reconstructs);
    /// The same for a quilt.
    PassRows(const QuiltGeometry& quilt, int block_side, bool reconstructs);

    /// Distances, in rows, of the data that a pass needs around a pixel: first samples for
    /// refinement, refined pixels for layers, layers for reconstruction, reconstructed pixels for
    /// the filter. The last three are 0 if the frame is not reconstructed.
    int refine_margin() const { return refine_margin_; }
    int estimated_from() const { return estimated_from_; }
    int reconstructed_from() const { return reconstructed_from_; }
    int filtered_from() const { return filtered_from_; }

    /// Margin around a counting row (see passes()) in which samples are needed.
    int sampled_from() const { return refined_from() + refine_margin_; }
    /// Margin around a counting row in which pixels must be refined: whole blocks.
    int refined_from() const;

    /// All passes: first samples; refinement; if the frame is reconstructed, layers and
    /// reconstruction; and a last one, which finishes the `requested` rows. `counting`: those
    /// requested rows that must come out as in the whole frame. Blocks begin at the first row.
    std::vector<SchedulePass> passes(const std::vector<bool>& requested,
                                     const std::vector<bool>& counting) const;

private:
    PassRows(int block_side, int refine_margin, std::optional<int> reused_from);
    int whole_blocks(int rows) const { return (rows + side_ - 1) / side_ * side_; }
    std::vector<bool> of_blocks(const std::vector<bool>& rows) const;

    int side_;
    bool reconstructs_;
    int refine_margin_, estimated_from_ = 0, reconstructed_from_ = 0, filtered_from_ = 0;
};

} // namespace integral

#endif
