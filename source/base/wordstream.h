// SPDX-License-Identifier: AGPL-3.0-or-later
// Copies blocks of four-byte numbers to and from a message stream, for the pixels that the back end
// sends to the front end.
#ifndef POVRAY_BASE_WORDSTREAM_H
#define POVRAY_BASE_WORDSTREAM_H

namespace pov_base
{

/// Copies `count` four-byte numbers. `order` is the stream's byte order, which must be the
/// machine's own or its reverse. Reduces `*left`, the number of bytes left in the stream, by 4 *
/// count. Returns false and does nothing if the order is another one or the stream is too short.
bool Copy_Words(const void *from, void *to, int count, const int order[4], int *left);

}

#endif
