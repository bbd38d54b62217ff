// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/reconstruction/pass_rows.h"

#include "integral/reconstruction/light_field_image.h"
#include "integral/reconstruction/noise_filter.h"
#include "integral/reconstruction/reconstruction.h"

#include <algorithm>
#include <cstddef>

namespace integral {

namespace {

/// The rows that are at most `reach` away from one of `rows`.
std::vector<bool> around(const std::vector<bool>& rows, int reach)
{
    std::vector<bool> result(rows.size());
    const int height = int(rows.size());
    for (int y = 0; y < height; ++y)
        if (rows[std::size_t(y)])
            std::fill(result.begin() + std::max(0, y - reach),
                      result.begin() + std::min(height, y + reach + 1), true);
    return result;
}

} // namespace

PassRows::PassRows(const LensSheet& sheet, const Film& film, int block_side, bool reconstructs)
    : PassRows(block_side, refine_margin_rows(sheet, film),
               reconstructs ? std::optional(ReuseNeighbourhood(Lattice(sheet), film).rows())
                            : std::nullopt)
{
}

PassRows::PassRows(const QuiltGeometry& quilt, int block_side, bool reconstructs)
    : PassRows(block_side, 1, reconstructs ? std::optional(ViewReuse(quilt).rows()) : std::nullopt)
{
}

/// `reused_from`: greatest distance of a pixel whose samples another pixel uses; nothing: the
/// picture is not reconstructed.
PassRows::PassRows(int block_side, int refine_margin, std::optional<int> reused_from)
    : side_(block_side), reconstructs_(reused_from.has_value()), refine_margin_(refine_margin)
{
    if (!reconstructs_)
        return;
    estimated_from_ = std::max({Reconstruction::reach_around, *reused_from, refine_margin_});
    reconstructed_from_ = 2 * Reconstruction::reach_around;
    filtered_from_ = NoiseFilter::rows;
}

int PassRows::refined_from() const
{
    return whole_blocks(filtered_from_) + whole_blocks(reconstructed_from_ + estimated_from_);
}

/// All rows of the blocks that contain one of `rows`.
std::vector<bool> PassRows::of_blocks(const std::vector<bool>& rows) const
{
    std::vector<bool> result(rows.size());
    const std::size_t side = std::size_t(side_);
    for (std::size_t y = 0; y < rows.size(); ++y)
        if (rows[y]) {
            const std::size_t top = y / side * side;
            std::fill(result.begin() + std::ptrdiff_t(top),
                      result.begin() + std::ptrdiff_t(std::min(rows.size(), top + side)), true);
        }
    return result;
}

std::vector<SchedulePass> PassRows::passes(const std::vector<bool>& requested,
                                           const std::vector<bool>& counting) const
{
    const std::vector<bool> reconstructed = of_blocks(around(counting, filtered_from_)),
                            estimated = around(reconstructed, reconstructed_from_),
                            refined = of_blocks(around(estimated, estimated_from_));
    std::vector<SchedulePass> passes = {{around(refined, refine_margin_), 0},
                                        {refined, refine_margin_}};
    if (reconstructs_) {
        passes.push_back({estimated, estimated_from_});
        passes.push_back({reconstructed, reconstructed_from_});
    }
    passes.push_back({requested, filtered_from_});
    return passes;
}

} // namespace integral
