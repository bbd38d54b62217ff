// SPDX-License-Identifier: AGPL-3.0-or-later
// Encodes pixels as integers for a file faster if there is no dithering.
#ifndef POVRAY_BASE_UNDITHERED_H
#define POVRAY_BASE_UNDITHERED_H

#include <typeinfo>

#include "base/image/encoding.h"

namespace pov_base
{

/// Encodes red, green and blue as integers from 0 to `max`, with the same result as
/// GetEncodedRGBValue, if `dithering` is a NoDither; otherwise returns false and does nothing. It
/// does not compute the rounding errors, which only dithering needs and which take as long as the
/// encoding.
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
