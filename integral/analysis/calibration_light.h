// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds the part of a calibration page that lies under the sheet, and measures leak, contrast and
// dot gain.
#ifndef INTEGRAL_ANALYSIS_CALIBRATION_LIGHT_H
#define INTEGRAL_ANALYSIS_CALIBRATION_LIGHT_H

#include "integral/analysis/calibration_fit.h"

#include <map>

namespace integral {

using MeasuredBlock = std::pair<const BandBlock*, BlockPhase>;

/// The part of the page that lies under the sheet, from the contrast of its beat bands. Refers to
/// the blocks, which must outlive it.
class SheetCover {
public:
    SheetCover(const std::vector<BandBlock>& blocks, const CalibrationLayout& layout,
               const SheetView& view);

    /// The beat blocks under the sheet: those with at least four tenths of the contrast of the
    /// ninth tenth, and little noise.
    const std::vector<MeasuredBlock>& blocks() const { return blocks_; }

    /// Whether a block of another kind lies under the sheet: the beat bands on both sides do.
    bool covers(const BandBlock& block) const;

private:
    struct Ends {
        double low, high; ///< mm along the bands
    };
    double along(Vec2 photo) const;
    bool has(int group, double at) const;

    SheetView view_;
    bool upright_ = false;
    int groups_ = 0;
    std::vector<MeasuredBlock> blocks_;
    std::map<int, Ends> ends_; ///< of the covered beat blocks of a group
};

struct CalibrationLight {
    /// Amplitude of lines half a pitch wide, divided by that without any blur.
    Estimate contrast;
    /// Shares of the light that an eye sees of a line of leak_line: from the line's own
    /// place, and from as far to the left and the right (towards larger x). The rest is seen
    /// farther away.
    bool leak_known = false;
    Estimate own, left, right;
    bool coverage_known = false;
    /// Whether fine lines look lighter than they are printed, which ink never makes them: the photo
    /// is over-exposed, or the sheet reflects light. Then nothing is known.
    bool too_light = false;
    std::array<Estimate, 3> coverage; ///< apparent, of fine lines that cover 1/4, 1/2 and 3/4
};

/// `contrast` is known if `coverage` is.
CalibrationLight calibration_light(const std::vector<BandBlock>& blocks,
                                   const CalibrationLayout& layout, const SheetView& view,
                                   const SheetCover& cover);

} // namespace integral

#endif
