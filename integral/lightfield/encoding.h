// SPDX-License-Identifier: AGPL-3.0-or-later
// How stored samples encode linear light.
#ifndef INTEGRAL_LIGHTFIELD_ENCODING_H
#define INTEGRAL_LIGHTFIELD_ENCODING_H

namespace integral {

struct Encoding {
    enum class Kind { linear, srgb, power } kind = Kind::srgb;
    double gamma = 2.2; ///< power: stored = linear^(1/gamma)
};

/// Linear light of an encoded value, and back. Odd functions: what is below 0 or above 1, as
/// float samples may be, is mapped by the same curve.
double decode(Encoding encoding, double value);
double encode(Encoding encoding, double linear);

bool same_encoding(Encoding a, Encoding b);

} // namespace integral

#endif
