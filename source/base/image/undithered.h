// SPDX-License-Identifier: AGPL-3.0-or-later
// A pixel's light as whole numbers of a file, where nothing is dithered.
#ifndef POVRAY_BASE_UNDITHERED_H
#define POVRAY_BASE_UNDITHERED_H

#include <typeinfo>

#include "base/image/encoding.h"

namespace pov_base
{

/// Encodes red, green and blue as whole numbers from 0 to `max`, the same as GetEncodedRGBValue's,
/// if `dithering` is a NoDither; otherwise returns false and does nothing. It leaves out the
/// rounding errors, which only a dithered neighbour needs and which take as long as the encoding.
template <class NoDither>
inline bool Encode_Undithered(const DitherHandler& dithering, const GammaCurvePtr& gamma,
                              unsigned int max, float linear_red, float linear_green,
                              float linear_blue, unsigned int& red, unsigned int& green,
                              unsigned int& blue)
{
    if (typeid(dithering) != typeid(NoDither))
        return false;
    red = IntEncode(gamma, linear_red, max);
    green = IntEncode(gamma, linear_green, max);
    blue = IntEncode(gamma, linear_blue, max);
    return true;
}

}

#endif
