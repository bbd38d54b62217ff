// SPDX-License-Identifier: AGPL-3.0-or-later
// Tabulates a curve that is evaluated often, such as an encoding's, to save run time.
#ifndef INTEGRAL_BASE_TABULATED_CURVE_H
#define INTEGRAL_BASE_TABULATED_CURVE_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace integral {

/// A piecewise linear approximation of a curve on 0 to 128. Its nodes are 0 and, from 2^-20 on, the
/// floats whose mantissas end in 16 zero bits. For x^a, 0 < a <= 1, the relative error from 2^-20
/// on is below 2e-6.
class TabulatedCurve {
public:
    /// `curve` takes a float and returns a number.
    template <class Curve> explicit TabulatedCurve(Curve curve)
    {
        for (std::size_t k = 0; k < values_.size(); ++k)
            values_[k] = float(curve(float_of(first + (std::uint32_t(k) << dropped))));
        zero_ = float(curve(0.0f));
    }

    /// The curve at x. The value at 0 for x < 0 and NaN; the value at 128 for x > 128.
    float operator()(float x) const
    {
        const float least = float_of(first);
        if (!(x >= least))
            return x > 0 ? zero_ + x / least * (values_[0] - zero_) : zero_;
        if (x >= 128)
            return values_.back();
        const std::uint32_t bits = bits_of(x), index = (bits - first) >> dropped;
        const float part = float(bits & ((1u << dropped) - 1)) * (1.0f / (1u << dropped));
        return values_[index] + part * (values_[index + 1] - values_[index]);
    }

private:
    static constexpr int dropped = 16, octaves = 27;
    static constexpr std::uint32_t first = std::uint32_t(127 - 20) << 23; // 2^-20
    static float float_of(std::uint32_t bits)
    {
        float x;
        std::memcpy(&x, &bits, sizeof x);
        return x;
    }
    static std::uint32_t bits_of(float x)
    {
        std::uint32_t bits;
        std::memcpy(&bits, &x, sizeof bits);
        return bits;
    }

    std::array<float, (octaves << (23 - dropped)) + 1> values_;
    float zero_;
};

} // namespace integral

#endif
