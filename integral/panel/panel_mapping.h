// SPDX-License-Identifier: AGPL-3.0-or-later
// Maps each subpixel of a panel to a view and to a place in the view's picture. A display's
// calibration and the optics of a lens sheet are both brought into this form before interlacing.
#ifndef INTEGRAL_PANEL_PANEL_MAPPING_H
#define INTEGRAL_PANEL_PANEL_MAPPING_H

#include "integral/base/parallel.h"
#include "integral/frame/frame_metadata.h"
#include "integral/frame/picture_fit.h"
#include "integral/frame/view_grid.h"
#include "integral/sheet/looking_glass.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace integral {

/// A phase with the given upper 16 bits: the middle of the range of such phases.
inline std::uint32_t phase_of_high(std::uint16_t phase16)
{
    return (std::uint32_t(phase16) << 16) + 32768;
}

/// Phases of the subpixels of a row.
struct PhaseRow {
    const std::uint32_t* phase32; ///< as in PhaseTable; null if the table has only their upper
                                  ///< halves
    const std::uint16_t* phase16; ///< as in PhaseTable; null if the table has whole phases
    std::uint32_t shift;
    bool is_one; ///< the first phase applies to all subpixels

    std::uint32_t operator[](int subpixel) const
    {
        const int i = is_one ? 0 : subpixel;
        return (phase32 ? phase32[i] : phase_of_high(phase16[i])) + shift;
    }

    /// The same row from a subpixel on.
    PhaseRow from(int subpixel) const
    {
        const int i = is_one ? 0 : subpixel;
        return {phase32 ? phase32 + i : nullptr, phase16 ? phase16 + i : nullptr, shift, is_one};
    }
};

/// Phases of a panel's subpixels. A phase is a place in a range in units of 2^-32 of the range, so
/// that sums wrap around by themselves.
struct PhaseTable {
    int rows = 0;    ///< row y of the panel uses row y % rows of the table; 0: there is no table
    int columns = 0; ///< phases in a row: one for each subpixel, or one for the whole row
    std::vector<std::uint32_t> phase32; ///< the phases, row by row; empty if `phase16` is filled
    std::vector<std::uint16_t> phase16; ///< only their upper 16 bits, which take half the memory
    std::vector<std::uint32_t> shift;   ///< added to all phases of a row of the panel; empty: 0

    /// The phases of a row of the panel.
    PhaseRow row(int y) const;
};

/// Subpixels are numbered along a row: red, green and blue of the leftmost pixel, and so on.
struct PanelMapping {
    int width = 0, height = 0; ///< of the panel, pixels
    /// The place in the viewing zone from which a subpixel is seen, measured from the zone's left
    /// side; behind lenses that lie across (horizontally), from below.
    PhaseTable across;
    PhaseTable up;   ///< the same, measured from below; no rows: views differ in one direction only
    PhaseTable x, y; ///< the place in the picture that the subpixel shows, from the left and the
                     ///< top
    /// Minimum and maximum of y.phase16 in each row of the panel, among seen subpixels; empty if
    /// the mapping is separable.
    std::vector<std::array<std::uint16_t, 2>> y_range;
    bool has_unseen = false; ///< subpixels whose phase across is `unseen` are black: no eye sees
                             ///< them, or they lie outside the picture
    /// Number of columns and rows at each side of the panel that lie outside the picture and are
    /// black.
    int left = 0, right = 0, top = 0, bottom = 0;

    /// Whether each row of the panel shows one height of the picture, all rows show the same
    /// columns of the picture, and every subpixel is seen, as with published mappings. Interlacing
    /// is faster then: it first blends two rows of the picture, and rounds the result.
    bool is_separable() const
    {
        return !across.phase32.empty() && x.rows == 1 && y.columns == 1 && !has_unseen;
    }

    static constexpr std::uint32_t unseen = 0xffff8000u;
};

/// The mapping that a display's maker publishes, for a picture in the given place on the panel.
PanelMapping mapping_of(const LookingGlassCalibration& calibration,
                        const FittedPicture& picture = {});

/// The mapping through the lenses of a panel that has the geometry of a frame. The mapping takes 16
/// bits per subpixel for each of across, x and y, and for up if lenses are round. `threads` and
/// `progress` as in for_each_row; returns nothing if `progress` stopped the work.
std::optional<PanelMapping> mapping_of(const FrameMetadata& geometry, EyeGrid eyes, int threads = 0,
                                       const Progress& progress = {},
                                       const FittedPicture& picture = {});

} // namespace integral

#endif
