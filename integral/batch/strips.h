// SPDX-License-Identifier: AGPL-3.0-or-later
// Divides a frame into strips of rows for several runs of the renderer, and joins the results. The
// pixels equal the frame rendered whole, unless the scene's light is random.
#ifndef INTEGRAL_BATCH_STRIPS_H
#define INTEGRAL_BATCH_STRIPS_H

#include "integral/frame/frame_metadata.h"

#include <string>
#include <vector>

namespace integral {

/// The rows of a frame, 0 at the top, that one run makes. The run also renders rows above and
/// below, because anti-aliasing compares pixels with neighbours.
struct RowStrip {
    int first = 0, rows = 0;
    int above = 0, below = 0; ///< further rendered rows
};

constexpr int usual_block_side = 32; ///< the renderer's blocks without Render_Block_Size

/// Divides a frame of `height` rows into at most `strips` (at least 1) strips of whole blocks, of
/// nearly equal height; a frame with fewer blocks has fewer strips. The renderer anti-aliases by
/// blocks (side `block_side` pixels, 32 unless set by Render_Block_Size) counted from its first
/// rendered row. So each strip, and the rows above it, begin at a block boundary of the whole
/// frame. `reach`: rows around a strip that affect it (PassRows::sampled_from); 0 without
/// anti-aliasing.
std::vector<RowStrip> row_strips(int height, int strips, int block_side, int reach);

/// The renderer's options for a strip of a frame of `height` rows: Start_Row, End_Row and, with
/// rows besides its own, Integral_Rows.
std::vector<std::string> options_of(const RowStrip& strip, int height);

/// Copies the rows of a strip from `rendered` to a picture `output`, whose document gives the rows'
/// position. `rendered` is the picture (PNG or OpenEXR), of the whole frame's size, that the
/// renderer wrote with options_of(strip). Throws InputError, OutputError.
void cut_strip(const std::string& rendered, const RowStrip& strip, const std::string& output);

/// Joins strips, files of cut_strip from the top down, to a frame of the same format, with their
/// common geometry, the sum of their seconds and the combined error. Throws InputError, naming the
/// strip, if one is missing, unreadable, out of place or part of another frame; OutputError.
void merge_strips(const std::vector<std::string>& strips, const std::string& output);

/// Error of a frame from its strips' errors: mean square weighted by `lit_pixels`. Strips are
/// audited independently, so the intervals of their mean squares add in quadrature; the result is
/// never narrower than the bias that all strips share.
ErrorEstimate combined(const std::vector<ErrorEstimate>& strips);

/// Lists the words in a scene's files (.pov and .inc; others are ignored) that make two renderings
/// differ: `radiosity`, `photons`, `media`, `jitter`, `crand`, `subsurface`. Comments and strings
/// do not count. Throws InputError.
std::vector<std::string> words_of_randomness(const std::vector<std::string>& files);

} // namespace integral

#endif
