// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/flip_loops.h"

#include "integral/compare/flip_kernels.h"

#include <cmath>
#include <cstdint>
#include <cstring>

#include "integral/base/vector_loops.h"

namespace integral {
namespace {

#define INTEGRAL_LANE __attribute__((always_inline)) inline

INTEGRAL_LANE std::int32_t bits_of(float x)
{
    std::int32_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return bits;
}

INTEGRAL_LANE float float_of(std::int32_t bits)
{
    float x;
    std::memcpy(&x, &bits, sizeof x);
    return x;
}

INTEGRAL_LANE float clamped(float x)
{
    const float above = x > 0 ? x : 0.0f; // NaN becomes 0
    return above < 1 ? above : 1.0f;
}

/// The cube root of x >= 0 by two of Halley's steps from a first guess by the exponent.
INTEGRAL_LANE float cube_root(float x)
{
    float y = float_of(std::int32_t(float(bits_of(x)) * (1.0f / 3)) + 709921077);
    for (int step = 0; step < 2; ++step) {
        const float cube = y * y * y;
        y = y * (cube + 2 * x) / (2 * cube + x);
    }
    return y;
}

/// The logarithm of x > 0 to base 2, by the series of atanh.
INTEGRAL_LANE float log2_of(float x)
{
    const std::int32_t root_of_half = 0x3f3504f3;
    const std::int32_t exponent = (bits_of(x) - root_of_half) >> 23;
    const float m = float_of(bits_of(x) - exponent * (1 << 23)); // sqrt(1/2) to sqrt(2)
    const float s = (m - 1) / (m + 1), t = s * s;
    const float series = 1 + t * (1 / 3.0f + t * (1 / 5.0f + t * (1 / 7.0f + t * (1 / 9.0f))));
    return float(exponent) + 2.885390082f * s * series; // 2 / ln 2
}

/// 2^x, for x from -126 to 127; 2^-126 below.
INTEGRAL_LANE float exp2_of(float x)
{
    const float in_range = x > -126 ? x : -126.0f;
    const float magic = 12582912; // 1.5 * 2^23: rounds to a whole number
    const float whole = (in_range + magic) - magic;
    const float f = (in_range - whole) * 0.6931471806f; // ln 2
    const float series = 1 +
                         f * (1 +
                              f * (1 / 2.0f +
                                   f * (1 / 6.0f +
                                        f * (1 / 24.0f +
                                             f * (1 / 120.0f + f * (1 / 720.0f + f / 5040.0f))))));
    return series * float_of((std::int32_t(whole) + 127) * (1 << 23));
}

/// x^p for x >= 0, p > 0.
INTEGRAL_LANE float power(float x, float p)
{
    const float tiny = 1e-30f;
    const float result = exp2_of(p * log2_of(x > tiny ? x : tiny));
    return x > tiny ? result : 0.0f;
}

/// The curve f of CIELAB.
INTEGRAL_LANE float lab_curve(float t)
{
    constexpr float delta = 6 / 29.0f;
    const float root = cube_root(t), line = t * (1 / (3 * delta * delta)) + 4 / 29.0f;
    return t > delta * delta * delta ? root : line;
}

struct Matrix {
    explicit Matrix(const double from[3][3])
    {
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                m[i][j] = float(from[i][j]);
    }
    float m[3][3];
};

struct Lab {
    float l, a, b;
};

/// CIELAB with Hunt's effect: colours are weaker where it is darker (section 4.1.2). x, y, z:
/// relative to white.
INTEGRAL_LANE Lab hunt_adjusted(float x, float y, float z)
{
    const float fx = lab_curve(x), fy = lab_curve(y), fz = lab_curve(z);
    const float l = 116 * fy - 16, scale = 0.01f * l;
    return {l, scale * 500 * (fx - fy), scale * 200 * (fy - fz)};
}

INTEGRAL_LANE float distance_of(Lab p, Lab q)
{
    const float da = p.a - q.a, db = p.b - q.b; // HyAB
    return std::fabs(p.l - q.l) + std::sqrt(da * da + db * db);
}

/// The perceived colour of filtered light, which is clamped to the gamut.
INTEGRAL_LANE Lab perceived(float y, float xy, float yz, const float to_rgb[3][3],
                            const float from_rgb[3][3])
{
    const float x = xy + y, z = y - yz;
    const float r = clamped(to_rgb[0][0] * x + to_rgb[0][1] * y + to_rgb[0][2] * z),
                g = clamped(to_rgb[1][0] * x + to_rgb[1][1] * y + to_rgb[1][2] * z),
                b = clamped(to_rgb[2][0] * x + to_rgb[2][1] * y + to_rgb[2][2] * z);
    return hunt_adjusted(from_rgb[0][0] * r + from_rgb[0][1] * g + from_rgb[0][2] * b,
                         from_rgb[1][0] * r + from_rgb[1][1] * g + from_rgb[1][2] * b,
                         from_rgb[2][0] * r + from_rgb[2][1] * g + from_rgb[2][2] * b);
}

constexpr float colour_exponent = 0.7f;              // q_c
constexpr float knee_of_colour = 0.4f, knee = 0.95f; // p_c, p_t

/// The greatest colour difference: between Hunt-adjusted green and blue, to the power of q_c.
float greatest_difference()
{
    const auto& m = flip_matrices().relative_from_rgb;
    const auto primary = [&](int k) {
        return hunt_adjusted(float(m[0][k]), float(m[1][k]), float(m[2][k]));
    };
    return power(distance_of(primary(1), primary(2)), colour_exponent);
}

} // namespace

INTEGRAL_VECTORS void opponent_from_rgb(const OpponentRow& to, const float* r, const float* g,
                                        const float* b, int count)
{
    const Matrix matrix(flip_matrices().relative_from_rgb);
    const auto& m = matrix.m;
    float* __restrict y = to.y, * __restrict xy = to.xy, * __restrict yz = to.yz;
    for (int i = 0; i < count; ++i) {
        const float red = clamped(r[i]), green = clamped(g[i]), blue = clamped(b[i]);
        const float x = m[0][0] * red + m[0][1] * green + m[0][2] * blue,
                    luminance = m[1][0] * red + m[1][1] * green + m[1][2] * blue,
                    z = m[2][0] * red + m[2][1] * green + m[2][2] * blue;
        y[i] = luminance;
        xy[i] = x - luminance;
        yz[i] = luminance - z;
    }
}

INTEGRAL_VECTORS void tone_map(float* __restrict to, const float* light, float factor, int count)
{
    for (int i = 0; i < count; ++i) {
        const float x = (light[i] > 0 ? light[i] : 0.0f) * factor;
        // Narkowicz's fit, as in flip_kernels.cpp.
        const float mapped = x * (0.9036f * x + 0.018f) / (x * (0.8748f * x + 0.354f) + 0.14f);
        // For very large x the quotient may be infinity / infinity.
        to[i] = x < 1e6f ? clamped(mapped) : 1.0f;
    }
}

INTEGRAL_VECTORS void set_four(float* __restrict to, const float* const from[4],
                               const float* centre, const float taps[4], int count)
{
    const float *a = from[0], *b = from[1], *c = from[2], *d = from[3];
    const float ta = taps[0], tb = taps[1], tc = taps[2], td = taps[3];
    for (int i = 0; i < count; ++i)
        to[i] = (ta * (a[i] - centre[i]) + tb * (b[i] - centre[i])) +
                (tc * (c[i] - centre[i]) + td * (d[i] - centre[i]));
}

INTEGRAL_VECTORS void add_four(float* __restrict to, const float* const from[4],
                               const float* centre, const float taps[4], int count)
{
    const float *a = from[0], *b = from[1], *c = from[2], *d = from[3];
    const float ta = taps[0], tb = taps[1], tc = taps[2], td = taps[3];
    for (int i = 0; i < count; ++i)
        to[i] += (ta * (a[i] - centre[i]) + tb * (b[i] - centre[i])) +
                 (tc * (c[i] - centre[i]) + td * (d[i] - centre[i]));
}

INTEGRAL_VECTORS void flip_of(float* __restrict to, const FlipRow& a, const FlipRow& b, int count)
{
    const Matrix to_rgb(flip_matrices().rgb_from_relative),
        from_rgb(flip_matrices().relative_from_rgb);
    const FlipRow p = a, q = b;
    static const float greatest = greatest_difference();
    const float limit = knee_of_colour * greatest;
    const float below = knee / limit, above = (1 - knee) / (greatest - limit);
    for (int i = 0; i < count; ++i) {
        const float hyab = distance_of(perceived(p.y[i], p.xy[i], p.yz[i], to_rgb.m, from_rgb.m),
                                       perceived(q.y[i], q.xy[i], q.yz[i], to_rgb.m, from_rgb.m));
        const float v = power(hyab, colour_exponent);
        const float colour = v < limit ? below * v : knee + above * (v - limit);
        const auto length = [](float x, float y) { return std::sqrt(x * x + y * y); };
        const float edge = std::fabs(length(p.edge_x[i], p.edge_y[i]) -
                                     length(q.edge_x[i], q.edge_y[i])),
                    point = std::fabs(length(p.point_x[i], p.point_y[i]) -
                                      length(q.point_x[i], q.point_y[i]));
        const float feature = std::sqrt((edge > point ? edge : point) * 0.7071067812f);
        to[i] = clamped(power(clamped(colour), 1 - clamped(feature)));
    }
}

INTEGRAL_VECTORS void keep_greater(float* __restrict to, const float* other, int count)
{
    for (int i = 0; i < count; ++i)
        to[i] = other[i] > to[i] ? other[i] : to[i];
}

} // namespace integral
