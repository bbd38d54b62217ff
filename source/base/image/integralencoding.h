// SPDX-License-Identifier: AGPL-3.0-or-later
// A pixel's light as whole numbers of a file, where nothing is dithered.
#ifndef POVRAY_BASE_INTEGRALENCODING_H
#define POVRAY_BASE_INTEGRALENCODING_H

#include <typeinfo>

#include "base/image/encoding.h"

namespace pov_base
{

/// Red, green and blue as whole numbers from 0 to `max`, as GetEncodedRGBValue finds them, if the picture is not dithered (`dithering` is a
/// NoDither). Without what rounding took from each: that is for a neighbouring pixel to make up for, and takes as long as the encoding.
template <class NoDither>
inline bool Integral_Encode_Undithered(const DitherHandler& dithering, const GammaCurvePtr& gamma, unsigned int max,
                                       float linear_red, float linear_green, float linear_blue,
                                       unsigned int& red, unsigned int& green, unsigned int& blue)
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
