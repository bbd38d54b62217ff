// SPDX-License-Identifier: AGPL-3.0-or-later
// Light and phase of a calibration page's bands, as a photograph shows them through the lens sheet.
#ifndef INTEGRAL_ANALYSIS_BAND_BLOCKS_H
#define INTEGRAL_ANALYSIS_BAND_BLOCKS_H

#include "integral/analysis/edge_response.h"
#include "integral/analysis/sheet_view.h"

namespace integral {

/// A small part of a band.
struct BandCell {
    int band;     ///< index into the layout's bands
    Vec2 photo;   ///< its middle
    double light; ///< mean linear light
    /// In fits of the block: falls to its ends, along the direction in which its phase changes, so
    /// that parts of periods there count little.
    double weight = 1;
};

/// The cells of a band between two places along it.
struct BandBlock {
    BandKind kind;
    int group, column; ///< column: from the band's beginning
    Vec2 photo;        ///< its middle
    std::vector<BandCell> cells;
};

/// The light of all bands; a tint is a block of one cell. Blocks that are not wholly in the photo
/// are left out.
std::vector<BandBlock> measure_blocks(const Plane& photo, const CalibrationPage& page,
                                      const CalibrationLayout& layout, const SheetView& view,
                                      int threads);

/// Divides the cells' light by that of the page at their place, as a surface of third degree
/// through the mean light of the beat blocks, which then is 1.
void divide_by_light(std::vector<BandBlock>& blocks, const SheetView& view);

/// The cells of a block: light = mean + amplitude cos(2 pi phase) + higher harmonics.
struct BlockPhase {
    double mean = 0, amplitude = 0;
    double difference = 0; ///< phase minus the view's phase, in periods, -0.5 to 0.5
    double residual = 0;   ///< root mean square of what remains, of the light
};

/// Nothing if the cells do not determine them, or hold less than most of a period.
std::optional<BlockPhase> phase_of(const BandBlock& block, const CalibrationLayout& layout,
                                   const SheetView& view);

/// Sets pitch, angle and phase of the view to the lattice that makes most of the beat bands' light,
/// with a pitch within 1.5% and an angle within 5 degrees of the view's. Throws
/// std::invalid_argument, with advice, if there is none.
void find_lattice(const std::vector<BandBlock>& blocks, const CalibrationLayout& layout,
                  SheetView& view);

} // namespace integral

#endif
