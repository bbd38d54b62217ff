// SPDX-License-Identifier: AGPL-3.0-or-later
// One frame rendered as strips of rows, by several runs of the renderer on as many machines, and
// put together again: the same pixels as the frame rendered whole, except where the scene's own
// light is random.
#ifndef INTEGRAL_BATCH_STRIPS_H
#define INTEGRAL_BATCH_STRIPS_H

#include "integral/lightfield/frame_metadata.h"

#include <string>
#include <vector>

namespace integral {

/// Rows of a frame, 0 at the top, that one run gives; it renders some more on either side, which
/// anti-aliasing looks at.
struct RowStrip {
    int first = 0, rows = 0;
    int above = 0, below = 0; ///< rows rendered besides
};

/// A frame's `height` rows in at most `strips` (at least 1) strips of whole blocks, as even as they
/// can be; a frame of fewer blocks has fewer. Anti-aliasing refines block by block, and the
/// renderer's blocks (`block_side` pixels, 32 unless Render_Block_Size says otherwise) are counted
/// from the first row that is rendered: strips begin, and their rows above do, where a block of the
/// whole frame begins. `reach` is rows_looked_at, or 0 without anti-aliasing.
std::vector<RowStrip> row_strips(int height, int strips, int block_side, int reach);

/// The renderer's options for a strip of a frame of `height` rows: Start_Row, End_Row and, with
/// rows besides its own, Integral_Rows.
std::vector<std::string> options_of(const RowStrip& strip, int height);

/// Writes to `output` the rows of a strip alone, of `rendered`, the picture (PNG or OpenEXR) that
/// the renderer wrote with options_of(strip): of the whole frame's size. Its document says which
/// rows they are. Throws InputError, OutputError.
void cut_strip(const std::string& rendered, const RowStrip& strip, const std::string& output);

/// Writes the frame that strips make, files of cut_strip from the top down: in their own format,
/// with their common geometry, the sum of their seconds and the error that their estimates tell of
/// the whole. Throws InputError, naming the strip, where one is missing, cannot be read, is out of
/// its place or of another frame; OutputError.
void merge_strips(const std::vector<std::string>& strips, const std::string& output);

/// The error of a frame from those of its strips, weighted by their lit pixels, which add up.
/// Strips are audited apart from each other: the mean squares' intervals add up as independent ones
/// do, but never below the bias that is common to all of them.
ErrorEstimate combined(const std::vector<ErrorEstimate>& strips);

/// Words of a scene's files (.pov, .inc; others are passed by) after which strips cannot be
/// promised to equal the whole frame, nor two runs each other: `radiosity`, `photons`, `media`,
/// `jitter`, `crand`, `subsurface`. Comments and strings do not count. Throws InputError.
std::vector<std::string> words_of_randomness(const std::vector<std::string>& files);

} // namespace integral

#endif
