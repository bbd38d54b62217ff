// SPDX-License-Identifier: AGPL-3.0-or-later
// Divides a frame into strips of rows, which several runs of the renderer make, and joins them. The
// pixels are those of the frame rendered whole, unless the scene's light is random.
#ifndef INTEGRAL_BATCH_STRIPS_H
#define INTEGRAL_BATCH_STRIPS_H

#include "integral/lightfield/frame_metadata.h"

#include <string>
#include <vector>

namespace integral {

/// The rows of a frame, 0 at the top, that one run makes. It renders more rows above and below,
/// which anti-aliasing compares them with.
struct RowStrip {
    int first = 0, rows = 0;
    int above = 0, below = 0; ///< further rows that are rendered
};

constexpr int usual_block_side = 32; ///< of the renderer's blocks without Render_Block_Size

/// Divides a frame of `height` rows into at most `strips` (at least 1) strips of whole blocks, of
/// nearly the same height; a frame with fewer blocks has fewer strips. The renderer anti-aliases
/// block by block (`block_side` pixels, 32 unless Render_Block_Size says otherwise), counted from
/// the first row that it renders. So each strip, and the rows above it, begin where a block of the
/// whole frame does. `reach` is PassRows::sampled_from, or 0 without anti-aliasing.
std::vector<RowStrip> row_strips(int height, int strips, int block_side, int reach);

/// The renderer's options for a strip of a frame of `height` rows: Start_Row, End_Row and, with
/// rows besides its own, Integral_Rows.
std::vector<std::string> options_of(const RowStrip& strip, int height);

/// Copies the rows of a strip from `rendered` to a picture `output`, whose document says which rows
/// they are. `rendered` is the picture (PNG or OpenEXR), of the whole frame's size, that the
/// renderer wrote with options_of(strip). Throws InputError, OutputError.
void cut_strip(const std::string& rendered, const RowStrip& strip, const std::string& output);

/// Joins strips, files of cut_strip from the top down, to a frame of the same format, with their
/// common geometry, the sum of their seconds and the error of the whole by their estimates. Throws
/// InputError, naming the strip, if one is missing, cannot be read, is out of its place or belongs
/// to another frame; OutputError.
void merge_strips(const std::vector<std::string>& strips, const std::string& output);

/// The error of a frame from those of its strips, weighted by their lit pixels, which add up.
/// Strips are audited independently, so the intervals of the mean squares add up as independent
/// ones do, but never below the bias that is common to all strips.
ErrorEstimate combined(const std::vector<ErrorEstimate>& strips);

/// Those words in a scene's files (.pov and .inc; others are ignored) that make two renderings of
/// it differ: `radiosity`, `photons`, `media`, `jitter`, `crand`, `subsurface`. Comments and
/// strings do not count. Throws InputError.
std::vector<std::string> words_of_randomness(const std::vector<std::string>& files);

} // namespace integral

#endif
