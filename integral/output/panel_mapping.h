// SPDX-License-Identifier: AGPL-3.0-or-later
// Which view and which place of its picture each subpixel of a panel shows: the one form into which
// both a display's calibration and the optics of a lens sheet are brought before interlacing.
#ifndef INTEGRAL_OUTPUT_PANEL_MAPPING_H
#define INTEGRAL_OUTPUT_PANEL_MAPPING_H

#include "integral/base/parallel.h"
#include "integral/lightfield/frame_metadata.h"
#include "integral/lightfield/picture_fit.h"
#include "integral/lightfield/view_grid.h"
#include "integral/output/looking_glass.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace integral {

/// The phase of which the upper 16 bits are known: the middle of what it can be.
inline std::uint32_t phase_of_high(std::uint16_t high)
{
    return (std::uint32_t(high) << 16) + 32768;
}

/// Phases of the subpixels of a row.
struct PhaseRow {
    const std::uint32_t* whole; ///< as in PhaseTable; null where it has only their upper halves
    const std::uint16_t* high;  ///< the reverse
    std::uint32_t shift;
    bool is_one; ///< the first phase is that of all subpixels

    std::uint32_t operator[](int subpixel) const
    {
        const int i = is_one ? 0 : subpixel;
        return (whole ? whole[i] : phase_of_high(high[i])) + shift;
    }

    /// The same row from a subpixel on.
    PhaseRow from(int subpixel) const
    {
        const int i = is_one ? 0 : subpixel;
        return {whole ? whole + i : nullptr, high ? high + i : nullptr, shift, is_one};
    }
};

/// Phases of a panel's subpixels. A phase is a place in a range in units of 2^-32 of the range, so
/// that sums wrap around by themselves.
struct PhaseTable {
    int rows = 0;    ///< row y of the panel uses row y % rows of the table; 0: there is no table
    int columns = 0; ///< phases in a row: one for each subpixel, or one for the whole row
    std::vector<std::uint32_t> whole; ///< the phases, row by row; empty where `high` is filled
    std::vector<std::uint16_t> high;  ///< their upper 16 bits alone, which take half the memory
    std::vector<std::uint32_t> shift; ///< added to all phases of a row of the panel; empty: 0

    /// The phases of a row of the panel.
    PhaseRow row(int y) const;
};

/// Subpixels are numbered along a row: red, green and blue of the leftmost pixel, and so on.
struct PanelMapping {
    int width = 0, height = 0; ///< of the panel, pixels
    /// From where in the viewing zone a subpixel is seen, from its left; behind lenses that lie
    /// across, from below.
    PhaseTable across;
    PhaseTable up;             ///< likewise from below; without rows: views differ one way alone
    PhaseTable x, y;           ///< which place of the picture it shows, from the left and the top
    /// The least and the greatest of y.high in each row of the panel, among what is seen; empty
    /// where the mapping is plain.
    std::vector<std::array<std::uint16_t, 2>> y_range;
    bool has_unseen = false; ///< subpixels whose phase across is `unseen` are black: they are seen
                             ///< by no eye, or lie beside the picture
    /// How many columns and rows of the panel at each side lie beside the picture and are black.
    int left = 0, right = 0, top = 0, bottom = 0;

    /// Whether a row of the panel shows one height of the picture, all rows show the same columns
    /// of it, and all is seen: as with published mappings. Interlacing is faster then:
    /// it first blends two rows of the picture, and rounds the result.
    bool is_plain() const
    {
        return !across.whole.empty() && x.rows == 1 && y.columns == 1 && !has_unseen;
    }

    static constexpr std::uint32_t unseen = 0xffff8000u;
};

/// The mapping that a display's maker publishes, for pictures that lie so on the panel.
PanelMapping mapping_of(const LookingGlassCalibration& calibration,
                        const FittedPicture& picture = {});

/// The mapping through the lenses of a panel that has the geometry of a frame. It takes 16 bits a
/// subpixel for each of across, x and y, and up where lenses are round. `threads` and `progress` as
/// in for_each_row; nothing where `progress` stopped the work.
std::optional<PanelMapping> mapping_of(const FrameMetadata& geometry, EyeGrid eyes, int threads = 0,
                                       const Progress& progress = {},
                                       const FittedPicture& picture = {});

} // namespace integral

#endif
