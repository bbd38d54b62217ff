// SPDX-License-Identifier: AGPL-3.0-or-later
// Clips POV-Ray's colours and converts them for comparing and averaging.
#ifndef POVRAY_BACKEND_INTEGRALCOLOURS_H
#define POVRAY_BACKEND_INTEGRALCOLOURS_H

#include <algorithm>

#include "backend/frame.h"
#include "base/image/colourspace.h"
#include "base/integralclipping.h"
#include "integral/frame/linear_colour.h"
#include "integral/reconstruction/light_field_image.h"

namespace pov
{

/// Converts a colour to the encoding in which anti-aliasing compares colours.
class ComparedEncoding
{
public:
    explicit ComparedEncoding(const GammaCurvePtr& gamma)
        : curve([&](float value) { return GammaCurve::Encode(gamma, value); }),
          inverse([&](float value) { return GammaCurve::Decode(gamma, value); })
    {
    }
    integral::ComparedColour operator()(const Colour& colour) const
    {
        return {curve(colour.red()), curve(colour.green()), curve(colour.blue()), colour.transm()};
    }
    const integral::TabulatedCurve& Curve() const { return curve; }
    /// The value whose encoding differs by `change` from the encoding of `value`; exactly `value`
    /// if `change` is 0.
    float Changed(float value, float change) const
    {
        const float encoded = curve(value);
        return value + (inverse(encoded + change) - inverse(encoded));
    }

private:
    integral::TabulatedCurve curve, inverse;
};

/// Clips light to what the picture file can hold. The clipped light is written in the same way as
/// the light itself: POV-Ray's encoding, too, makes light brighter than its opacity more opaque.
inline void Clip(pov_base::IntegralClipping clipping, Colour& light)
{
    if (clipping == pov_base::IntegralClipping::none)
        return;
    const bool by_brightness = clipping == pov_base::IntegralClipping::brightness;
    const auto is_held = [](float value) { return !(value < 0 || value > 1); }; // NaN, too
    const float brightness = light.greyscale();
    if (by_brightness ? is_held(brightness)
                      : is_held(light.red()) && is_held(light.green()) && is_held(light.blue()))
        return;
    light.transm() = std::min(light.transm(), std::max(0.0f, 1 - brightness));
    const float scale = brightness > 1 ? 1 / brightness : 0;
    for (int channel = 0; channel < 3; channel++)
        light[channel] = by_brightness ? scale * light[channel]
                                       : std::clamp(light[channel], 0.0f, 1.0f);
}

inline integral::LinearColour Linear(const Colour& colour)
{
    return {colour.red(), colour.green(), colour.blue(), colour.transm()};
}

}

#endif
