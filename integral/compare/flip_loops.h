// SPDX-License-Identifier: AGPL-3.0-or-later
// Inner loops of FLIP over contiguous floats, compiled to vector instructions. The results are the
// same on every processor.
#ifndef INTEGRAL_COMPARE_FLIP_LOOPS_H
#define INTEGRAL_COMPARE_FLIP_LOOPS_H

namespace integral {

/// Light in the opponent colours that FLIP filters, linear in R, G and B: Y, X - Y and Y - Z,
/// relative to white (YCxCz of the paper without its offset and factors).
struct OpponentRow {
    float *y, *xy, *yz;
};

/// Converts a row of linear light, clamped to 0 to 1.
void opponent_from_rgb(const OpponentRow& to, const float* r, const float* g, const float* b,
                       int count);

/// Multiplies light by `factor` and maps it by ACES' filmic curve to 0 to 1.
void tone_map(float* to, const float* light, float factor, int count);

/// set_four: to = sum of taps[k] (from[k] - centre) over four rows; add_four: to += that sum.
void set_four(float* to, const float* const from[4], const float* centre, const float taps[4],
              int count);
void add_four(float* to, const float* const from[4], const float* centre, const float taps[4],
              int count);

/// The filtered rows of one picture.
struct FlipRow {
    const float *y, *xy, *yz;                         ///< as the eye resolves them
    const float *edge_x, *edge_y, *point_x, *point_y; ///< results of the detectors
};

/// FLIP of each pixel, 0 to 1.
void flip_of(float* to, const FlipRow& a, const FlipRow& b, int count);

/// to = max(to, other)
void keep_greater(float* to, const float* other, int count);

} // namespace integral

#endif
