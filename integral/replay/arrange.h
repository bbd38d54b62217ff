// SPDX-License-Identifier: AGPL-3.0-or-later
// Several views as one picture.
#ifndef INTEGRAL_REPLAY_ARRANGE_H
#define INTEGRAL_REPLAY_ARRANGE_H

#include "integral/replay/replay.h"

#include <vector>

namespace integral {

/// Eyes `separation` mm apart, left and right of `middle`.
std::vector<Eye> eye_pair(Eye middle, double separation);

/// columns x rows eyes, row by row from the top left, at the middles of as many equal parts of a rectangle about `middle`:
/// width x height mm.
std::vector<Eye> eye_grid(Eye middle, int columns, int rows, double width, double height);

/// The pictures, all of one size and form, row by row from the top left, `columns` in a row, with `border` pixels of black
/// (opaque) between them. Throws std::invalid_argument where they differ, or are none.
Image tiled(const std::vector<Image>& pictures, int columns, int border);

/// A stereo pair for red-cyan glasses: red of the left picture, green and blue of the right; the mean alpha. In the encoded
/// values, as such glasses are used with screens and prints. Throws as `tiled` does.
Image anaglyph(const Image& left, const Image& right);

} // namespace integral

#endif
