// SPDX-License-Identifier: AGPL-3.0-or-later
// Encodes linear light as stored samples, and decodes them.
#ifndef INTEGRAL_FRAME_ENCODING_H
#define INTEGRAL_FRAME_ENCODING_H

namespace integral {

struct Encoding {
    enum class Kind { linear, srgb, power } kind = Kind::srgb;
    double gamma = 2.2; ///< power: stored = linear^(1/gamma)
};

/// The linear light of an encoded value, and its inverse. Defined for all numbers, since float
/// samples may be outside 0 to 1: both are odd functions, and values above 1 follow the same curve.
double decode(Encoding encoding, double value);
double encode(Encoding encoding, double linear);

bool same_encoding(Encoding a, Encoding b);

} // namespace integral

#endif
