// SPDX-License-Identifier: AGPL-3.0-or-later
// Lists the film pixels that each lens images.
#ifndef INTEGRAL_WIREFRAME_LENS_PIXELS_H
#define INTEGRAL_WIREFRAME_LENS_PIXELS_H

#include "integral/optics/lens_mapping.h"

#include <vector>

namespace integral {

/// Neighbouring pixels of one row of the film whose centres a lens images: [first, end).
struct LensRun {
    LensIndex lens;
    int row, first, end;
};

/// The pixels of every lens that has any, as the renderer maps them. Immutable.
class LensPixels {
public:
    /// `shift`: offset of a colour's subpixels from their pixels' centres, in pixels, +y down.
    LensPixels(const SheetOptics& optics, const Film& film, LensMapping mapping, Vec2 shift,
               int threads);

    /// Number of lenses that have pixels. They are numbered from 0, row by row of lenses.
    int count() const { return int(first_run_.size()) - 1; }
    LensIndex lens(int number) const { return runs_[first_run_[std::size_t(number)]].lens; }
    /// A lens's runs, by row: [begin, end).
    const LensRun* begin(int number) const { return &runs_[first_run_[std::size_t(number)]]; }
    const LensRun* end(int number) const
    {
        return runs_.data() + first_run_[std::size_t(number) + 1];
    }

private:
    std::vector<LensRun> runs_;
    std::vector<std::size_t> first_run_; ///< index by lens, then the number of all runs
};

} // namespace integral

#endif
