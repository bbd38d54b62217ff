// SPDX-License-Identifier: AGPL-3.0-or-later
// Selects how each ray's light is clipped before it is averaged to a pixel: in the same way as the
// picture file will clip the pixel. Otherwise light above 1 would outweigh all else that a lens
// sees.
#ifndef POVRAY_BASE_INTEGRALCLIPPING_H
#define POVRAY_BASE_INTEGRALCLIPPING_H

class POVMS_Object;

namespace pov_base
{

enum class IntegralClipping
{
    none,      ///< the file holds all light: OpenEXR, Radiance HDR
    colours,   ///< red, green and blue to 0...1
    brightness ///< the brightness to 0...1: a greyscale file
};

/// The clipping for the output file of a render.
IntegralClipping Read_Integral_Clipping(POVMS_Object& options);

}

#endif
