// SPDX-License-Identifier: AGPL-3.0-or-later
// Which of a film's pixels each lens images.
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

/// The pixels of every lens that images any, as the renderer maps them. Immutable.
class LensPixels {
public:
    /// `shift`: of a colour's subpixels from their pixels' centres, in pixels, +y down.
    LensPixels(const SheetOptics& optics, const Film& film, LensMapping mapping, Vec2 shift,
               int threads);

    /// Number of lenses that have pixels, numbered from 0 by row of lenses, then along it.
    int count() const { return int(first_run_.size()) - 1; }
    LensIndex lens(int number) const { return runs_[first_run_[std::size_t(number)]].lens; }
    /// Its runs, by row: [begin, end).
    const LensRun* begin(int number) const { return &runs_[first_run_[std::size_t(number)]]; }
    const LensRun* end(int number) const
    {
        return runs_.data() + first_run_[std::size_t(number) + 1];
    }

private:
    std::vector<LensRun> runs_;
    std::vector<std::size_t> first_run_; ///< of each lens, and the number of all runs
};

} // namespace integral

#endif
