// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/row_loops.h"

#include <algorithm>

#include "integral/base/vector_loops.h"

namespace integral {

INTEGRAL_VECTORS void mix_rows(float* __restrict to, const float* a, const float* b, const float* c,
                               const float* d, const float weight[4], int count)
{
    const float w0 = weight[0], w1 = weight[1], w2 = weight[2], w3 = weight[3];
    for (int i = 0; i < count; ++i)
        to[i] = w0 * a[i] + w1 * b[i] + w2 * c[i] + w3 * d[i];
}

INTEGRAL_VECTORS void vote_for(float* __restrict vote, const RowsToCompare& rows, int count)
{
    const float *r = rows.view[0], *g = rows.view[1], *b = rows.view[2], *r0 = rows.middle[0],
                *g0 = rows.middle[1], *b0 = rows.middle[2], *sharpness = rows.sharpness;
    for (int i = 0; i < count; ++i) {
        const float dr = r[i] - r0[i], dg = g[i] - g0[i], db = b[i] - b0[i];
        vote[i] = 1 / (1 + sharpness[i] * (dr * dr + dg * dg + db * db));
    }
}

INTEGRAL_VECTORS void vote_between(float* __restrict vote, const RowsToCompare& rows,
                                   const float weight[4], int count)
{
    const float *r = rows.view[0], *g = rows.view[1], *b = rows.view[2], *r0 = rows.middle[0],
                *g0 = rows.middle[1], *b0 = rows.middle[2], *sharpness = rows.sharpness;
    const float w0 = weight[0], w1 = weight[1], w2 = weight[2], w3 = weight[3];
    for (int i = 0; i < count; ++i) {
        const float dr = w0 * r[i - 1] + w1 * r[i] + w2 * r[i + 1] + w3 * r[i + 2] - r0[i],
                    dg = w0 * g[i - 1] + w1 * g[i] + w2 * g[i + 1] + w3 * g[i + 2] - g0[i],
                    db = w0 * b[i - 1] + w1 * b[i] + w2 * b[i + 1] + w3 * b[i + 2] - b0[i];
        vote[i] = 1 / (1 + sharpness[i] * (dr * dr + dg * dg + db * db));
    }
}

INTEGRAL_VECTORS void add(float* __restrict to, const float* from, int count)
{
    for (int i = 0; i < count; ++i)
        to[i] += from[i];
}

INTEGRAL_VECTORS void add_product(float* __restrict to, const float* weight, const float* from,
                                  int count)
{
    for (int i = 0; i < count; ++i)
        to[i] += weight[i] * from[i];
}

INTEGRAL_VECTORS void multiply(float* __restrict to, const float* factor, int count)
{
    for (int i = 0; i < count; ++i)
        to[i] *= factor[i];
}

} // namespace integral
