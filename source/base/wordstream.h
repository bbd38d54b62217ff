// SPDX-License-Identifier: AGPL-3.0-or-later
// Numbers of four bytes in a message's stream, copied all at once: the pixels that the back end
// sends to the front end.
#ifndef POVRAY_BASE_WORDSTREAM_H
#define POVRAY_BASE_WORDSTREAM_H

namespace pov_base
{

/// Copies `count` numbers of four bytes. `order` is the stream's byte order: the machine's own or
/// its reverse. `*left`, the bytes that are left in the stream, falls by 4 * count. Returns false,
/// with nothing done, for another order or too short a stream.
bool Copy_Words(const void *from, void *to, int count, const int order[4], int *left);

}

#endif
