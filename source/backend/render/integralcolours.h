// SPDX-License-Identifier: AGPL-3.0-or-later
// POV-Ray's colours as anti-aliasing compares and averages them.
#ifndef POVRAY_BACKEND_INTEGRALCOLOURS_H
#define POVRAY_BACKEND_INTEGRALCOLOURS_H

#include "backend/frame.h"
#include "base/image/colourspace.h"
#include "integral/lightfield/first_samples.h"
#include "integral/lightfield/linear_colour.h"

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
    /// The value whose encoding differs by `change` from that of a value. Exactly the same if it
    /// does not differ.
    float Changed(float value, float change) const
    {
        const float encoded = curve(value);
        return value + (inverse(encoded + change) - inverse(encoded));
    }

private:
    integral::TabulatedCurve curve, inverse;
};

inline integral::LinearColour Linear(const Colour& colour)
{
    return {colour.red(), colour.green(), colour.blue(), colour.transm()};
}

}

#endif
