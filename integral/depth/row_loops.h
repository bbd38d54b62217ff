// SPDX-License-Identifier: AGPL-3.0-or-later
// Inner loops of depth measurement over contiguous floats, compiled to vector instructions. The
// results are the same on every processor.
#ifndef INTEGRAL_DEPTH_ROW_LOOPS_H
#define INTEGRAL_DEPTH_ROW_LOOPS_H

namespace integral {

/// to = weight[0] a + weight[1] b + weight[2] c + weight[3] d
void mix_rows(float* to, const float* a, const float* b, const float* c, const float* d,
              const float weight[4], int count);

/// The colours to compare: three channels of a view, and of the middle view; and the sharpness of
/// the middle view's pixels, 1 / allowed squared difference.
struct RowsToCompare {
    const float* view[3];
    const float* middle[3];
    const float* sharpness;
};

/// vote = max(0, 1 - sharpness |view - middle|^2) of `count` pixels.
void vote_for(float* vote, const RowsToCompare& rows, int count);

/// The same between the view's columns: pixel i is the sum of weight[k] times its pixel i - 1 + k.
void vote_between(float* vote, const RowsToCompare& rows, const float weight[4], int count);

/// to += from
void add(float* to, const float* from, int count);

/// to += weight from
void add_product(float* to, const float* weight, const float* from, int count);

/// to *= factor
void multiply(float* to, const float* factor, int count);

} // namespace integral

#endif
