// SPDX-License-Identifier: AGPL-3.0-or-later
// A second implementation of FLIP, for tests: slow, in long double, with the filters as whole
// squares of weights, written from the equations of Andersson and others (2020, 2021). Shares
// nothing with integral/compare but std::vector.
#ifndef TESTS_UNIT_FLIP_ORACLE_H
#define TESTS_UNIT_FLIP_ORACLE_H

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace flip_oracle {

using Real = long double;
using Three = std::array<Real, 3>;
const Real pi = std::acos(Real(-1));

/// Linear sRGB light, row by row.
struct Picture {
    int width, height;
    std::vector<Three> pixels;
    Three at(int x, int y) const // continues at the edges
    {
        return pixels[std::size_t(std::clamp(y, 0, height - 1)) * width +
                      std::clamp(x, 0, width - 1)];
    }
};

// XYZ of sRGB as published with IEC 61966-2-1, in ten digits, and its white.
const Real to_xyz[3][3] = {{0.4123907993L, 0.3575843394L, 0.1804807884L},
                           {0.2126390059L, 0.7151686788L, 0.0721923154L},
                           {0.0193308187L, 0.1191947798L, 0.9505321522L}};
const Real from_xyz[3][3] = {{3.2409699419L, -1.5373831776L, -0.4986107603L},
                             {-0.9692436363L, 1.8759675015L, 0.0415550574L},
                             {0.0556300797L, -0.2039769589L, 1.0569715142L}};
const Three white = {0.9504559271L, 1, 1.0890577508L};

inline Three times(const Real m[3][3], Three v)
{
    Three r;
    for (int i = 0; i < 3; ++i)
        r[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return r;
}

inline Three ycxcz(Three rgb)
{
    Three t = times(to_xyz, rgb);
    for (int i = 0; i < 3; ++i)
        t[i] /= white[i];
    return {116 * t[1] - 16, 500 * (t[0] - t[1]), 200 * (t[1] - t[2])};
}

inline Three rgb_of(Three opponent)
{
    const Real y = (opponent[0] + 16) / 116, x = y + opponent[1] / 500, z = y - opponent[2] / 200;
    return times(from_xyz, {x * white[0], y * white[1], z * white[2]});
}

inline Three hunt_lab(Three rgb)
{
    const Three t = times(to_xyz, rgb);
    const auto f = [](Real v) {
        const Real delta = Real(6) / 29;
        return v > delta * delta * delta ? std::cbrt(v) : v / (3 * delta * delta) + Real(4) / 29;
    };
    const Real x = f(t[0] / white[0]), y = f(t[1] / white[1]), z = f(t[2] / white[2]);
    const Real l = 116 * y - 16;
    return {l, l / 100 * 500 * (x - y), l / 100 * 200 * (y - z)};
}

inline Real hyab(Three p, Three q)
{
    return std::fabs(p[0] - q[0]) + std::hypot(p[1] - q[1], p[2] - q[2]);
}

/// A square of weights, (2 radius + 1)^2.
struct Square {
    int radius;
    std::vector<Real> weights;
    Real& at(int x, int y)
    {
        return weights[std::size_t((y + radius) * (2 * radius + 1) + x + radius)];
    }
};

inline Square square(int radius, const std::function<Real(int, int)>& weight)
{
    Square s{radius, std::vector<Real>(std::size_t((2 * radius + 1) * (2 * radius + 1)))};
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x)
            s.at(x, y) = weight(x, y);
    return s;
}

inline Real filtered(const Picture& picture, int channel, Square& s, int x, int y)
{
    Real sum = 0;
    for (int j = -s.radius; j <= s.radius; ++j)
        for (int i = -s.radius; i <= s.radius; ++i)
            sum += s.at(i, j) * picture.at(x + i, y + j)[channel];
    return sum;
}

/// The contrast sensitivity's filter, of sum 1.
inline Square sensitivity(Real a1, Real b1, Real a2, Real b2, Real ppd)
{
    const int radius = int(std::ceil(3 * std::sqrt(Real(0.04L) / (2 * pi * pi)) * ppd));
    Square s = square(radius, [&](int x, int y) {
        const Real d = (Real(x) * x + Real(y) * y) / (ppd * ppd);
        return a1 * std::sqrt(pi / b1) * std::exp(-pi * pi * d / b1) +
               a2 * std::sqrt(pi / b2) * std::exp(-pi * pi * d / b2);
    });
    Real sum = 0;
    for (const Real w : s.weights)
        sum += w;
    for (Real& w : s.weights)
        w /= sum;
    return s;
}

/// An edge's or point's detector across x, or across y.
inline Square detector(bool point, bool across_y, Real ppd)
{
    const Real deviation = Real(0.5L) * Real(0.082L) * ppd;
    const int radius = int(std::ceil(3 * deviation));
    Square s = square(radius, [&](int x, int y) {
        const Real along = across_y ? y : x, d = (Real(x) * x + Real(y) * y);
        const Real g = std::exp(-d / (2 * deviation * deviation));
        return point ? (along * along / (deviation * deviation) - 1) * g : -along * g;
    });
    Real positive = 0, negative = 0;
    for (const Real w : s.weights)
        (w > 0 ? positive : negative) += w;
    for (Real& w : s.weights)
        w /= w > 0 ? positive : -negative;
    return s;
}

/// The LDR-FLIP map.
inline std::vector<Real> map_of(const Picture& a, const Picture& b, Real ppd)
{
    Square filters[3] = {sensitivity(1, 0.0047L, 0, 1e-5L, ppd),
                         sensitivity(1, 0.0053L, 0, 1e-5L, ppd),
                         sensitivity(34.1L, 0.04L, 13.5L, 0.025L, ppd)};
    Square edges[2] = {detector(false, false, ppd), detector(false, true, ppd)},
           points[2] = {detector(true, false, ppd), detector(true, true, ppd)};
    Picture opponent[2] = {a, b}, grey[2] = {a, b};
    for (int k = 0; k < 2; ++k)
        for (std::size_t i = 0; i < opponent[k].pixels.size(); ++i) {
            Three& p = opponent[k].pixels[i];
            for (Real& c : p)
                c = std::clamp(c, Real(0), Real(1));
            p = ycxcz(p);
            grey[k].pixels[i] = {(p[0] + 16) / 116, 0, 0};
        }
    const Real greatest = std::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), Real(0.7L));
    const Real knee = Real(0.4L) * greatest;
    std::vector<Real> map;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            Three seen[2];
            Real edge[2], point[2];
            for (int k = 0; k < 2; ++k) {
                Three c;
                for (int channel = 0; channel < 3; ++channel)
                    c[channel] = filtered(opponent[k], channel, filters[channel], x, y);
                c = rgb_of(c);
                for (Real& v : c)
                    v = std::clamp(v, Real(0), Real(1));
                seen[k] = hunt_lab(c);
                edge[k] = std::hypot(filtered(grey[k], 0, edges[0], x, y),
                                     filtered(grey[k], 0, edges[1], x, y));
                point[k] = std::hypot(filtered(grey[k], 0, points[0], x, y),
                                      filtered(grey[k], 0, points[1], x, y));
            }
            const Real v = std::pow(hyab(seen[0], seen[1]), Real(0.7L));
            const Real colour = v < knee
                                    ? Real(0.95L) / knee * v
                                    : Real(0.95L) + (v - knee) / (greatest - knee) * Real(0.05L);
            const Real feature = std::sqrt(
                std::max(std::fabs(edge[0] - edge[1]), std::fabs(point[0] - point[1])) /
                std::sqrt(Real(2)));
            map.push_back(std::pow(colour, 1 - feature));
        }
    return map;
}

/// Tone-maps light by the ACES curve (Narkowicz's fit, exposure factor 0.6).
inline Real aces(Real light)
{
    const Real x = Real(0.6L) * std::max(light, Real(0));
    return std::clamp(x * (Real(2.51L) * x + Real(0.03L)) /
                          (x * (Real(2.43L) * x + Real(0.59L)) + Real(0.14L)),
                      Real(0), Real(1));
}

/// The HDR-FLIP map, at `count` exposures from `start` to `stop`.
inline std::vector<Real> hdr_map_of(const Picture& a, const Picture& b, Real ppd, Real start,
                                    Real stop, int count)
{
    std::vector<Real> greatest(a.pixels.size(), 0);
    for (int k = 0; k < count; ++k) {
        Picture shown[2] = {a, b};
        for (Picture& picture : shown)
            for (Three& pixel : picture.pixels)
                for (Real& c : pixel)
                    c = aces(c * std::exp2(count > 1 ? start + k * (stop - start) / (count - 1)
                                                     : start));
        const auto map = map_of(shown[0], shown[1], ppd);
        for (std::size_t i = 0; i < map.size(); ++i)
            greatest[i] = std::max(greatest[i], map[i]);
    }
    return greatest;
}

} // namespace flip_oracle

#endif
