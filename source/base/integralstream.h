// SPDX-License-Identifier: AGPL-3.0-or-later
// Blocks of pixels between the renderer's two halves: POV-Ray's messages put them into a stream, and take them out, byte by byte.
#ifndef POVRAY_BASE_INTEGRALSTREAM_H
#define POVRAY_BASE_INTEGRALSTREAM_H

namespace pov_base
{

/// Copies `count` numbers of four bytes, all at once, with their bytes in a stream's `order`: as they are, or turned round. `left`, the
/// bytes that the stream has left, falls by what was copied. False, with nothing done, if the order is another or the stream too short.
bool Copy_Integral_Words(const void *from, void *to, int count, const int order[4], int *left);

}

#endif
