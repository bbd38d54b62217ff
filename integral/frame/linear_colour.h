// SPDX-License-Identifier: AGPL-3.0-or-later
// Linear light: the type for averaging it, its compact storage, and the comparison of colours.
#ifndef INTEGRAL_FRAME_LINEAR_COLOUR_H
#define INTEGRAL_FRAME_LINEAR_COLOUR_H

#include "integral/base/four_floats.h"
#include "integral/base/tabulated_curve.h"

#include <cmath>

namespace integral {

/// Red, green, blue and transparency in linear light. Components may be negative, since pigments
/// may be; negative light counts in a pixel's mean.
using LinearColour = std::array<float, 4>;

/// The squared difference of two colours, encoded by `encode`, summed over the components;
/// transparency is not encoded.
float squared_difference(const TabulatedCurve& encode, const LinearColour& a,
                         const LinearColour& b);

/// Stores a LinearColour in 8 bytes: square roots with the light's sign, so that the error in sRGB
/// encoding is below 0.0002 of full scale. Components from -64 to 64.
class StoredLight {
public:
    StoredLight() = default;
    explicit StoredLight(const LinearColour& light)
    {
        for (std::size_t k = 0; k < light.size(); ++k)
            roots_[k] = rounded_root(light[k]);
    }
    LinearColour light() const
    {
        LinearColour light;
        for (std::size_t k = 0; k < light.size(); ++k)
            light[k] = float(roots_[k]) * std::fabs(float(roots_[k])) * of_squared_root;
        return light;
    }
    FourFloats four() const
    {
        const FourFloats roots = floats_from(&roots_);
        return of_squared_root * roots * abs(roots);
    }
    /// Whether a light can be stored: all components are numbers from -64 to 64.
    static bool holds(const LinearColour& light);

    /// A component is of_squared_root times the square of the stored integer, with the integer's
    /// sign.
    static constexpr float levels = 4095, of_squared_root = 1 / (levels * levels);

private:
    /// Returns 0 for NaN. Uses comparisons, since fmin is a function call.
    static std::int16_t rounded_root(float x)
    {
        constexpr float most = 32767;
        const float root = std::sqrt(std::fabs(x)) * levels;
        if (root < most)
            return std::int16_t(std::lrint(x < 0 ? -root : root));
        return std::int16_t(x < 0 ? -most : x > 0 ? most : 0);
    }

    std::array<std::int16_t, 4> roots_{};
};

} // namespace integral

#endif
