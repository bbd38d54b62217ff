// SPDX-License-Identifier: AGPL-3.0-or-later
// Points of the unit cube at which a pixel's light is sampled: random bits, points that are spread
// evenly over four dimensions, and coordinates whose sum is.
#ifndef INTEGRAL_LIGHTFIELD_SAMPLE_POINTS_H
#define INTEGRAL_LIGHTFIELD_SAMPLE_POINTS_H

#include <array>
#include <cstdint>

namespace integral {

/// 64 bits that look random, of a seed and a value: the same for the same, and unlike for unlike
/// ones.
std::uint64_t random_bits(std::uint64_t seed, std::uint64_t value);

constexpr int point_dimensions = 4;

/// Which scrambling of the sequence: one for each dimension.
using PointSeeds = std::array<std::uint32_t, point_dimensions>;
PointSeeds point_seeds(std::uint64_t key);

/// Point `index` of Sobol's sequence, each coordinate scrambled (Owen 1995: each bit is flipped or
/// not, as the bits above it decide), in (0, 1). Among any 4^k points that begin at a multiple of
/// 4^k each coordinate is once in each 4^k-th part, and the first two together once in each square
/// of side 2^-k.
std::array<double, point_dimensions> scrambled_point(const PointSeeds& seeds, std::uint32_t index);

/// (u, v) in (0, 1)^2 -> two coordinates from 0 to 1, area-preserving, such that first +
/// ratio*second follows from u alone, and always rises or always falls with it: where u is spread
/// evenly, so is that sum, by its own density.
class SumSplit {
public:
    struct Parts {
        double first, second;
    };

    /// `ratio`: any number, infinite too.
    explicit SumSplit(double ratio = 0);

    Parts operator()(double u, double v) const;

private:
    bool second_is_wide_;
    double narrow_, of_narrow_; // breadth of the narrow one's part of the sum, the other's being 1;
                                // signed, 1 / that, or 0
};

} // namespace integral

#endif
