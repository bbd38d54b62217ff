// SPDX-License-Identifier: AGPL-3.0-or-later
// Sample points for a pixel's light: random bits, a low-discrepancy sequence in four dimensions,
// and a mapping, with its inverse, to pairs of coordinates whose weighted sums are well
// distributed.
#ifndef INTEGRAL_SAMPLING_SAMPLE_POINTS_H
#define INTEGRAL_SAMPLING_SAMPLE_POINTS_H

#include <array>
#include <cstdint>

namespace integral {

/// 64 pseudo-random bits from a seed and a value (a hash of the two).
std::uint64_t random_bits(std::uint64_t seed, std::uint64_t value);

constexpr int point_dimensions = 4;

/// The seeds of the sequence's scrambling, one for each dimension, and their derivation from a key.
using PointSeeds = std::array<std::uint32_t, point_dimensions>;
PointSeeds point_seeds(std::uint64_t key);

/// A point of the unit hypercube.
using UnitPoint = std::array<double, point_dimensions>;

/// Point `index` of the Sobol sequence with Owen scrambling (Owen 1995: whether a bit is flipped
/// depends on the bits above it). Coordinates are in (0, 1). Among 4^k consecutive points that
/// begin at a multiple of 4^k, each coordinate falls once into each of 4^k equal intervals, and the
/// first two coordinates fall once into each square of side 2^-k.
UnitPoint scrambled_point(const PointSeeds& seeds, std::uint32_t index);

/// The sequence of scrambled_point, shifted so that it begins at a given point: the bits in which
/// this point differs from the sequence's first point are flipped in all points (a digital shift).
/// The shift keeps the points as evenly distributed.
class ShiftedPoints {
public:
    ShiftedPoints() = default;
    /// Coordinates of `first` are in [0, 1].
    ShiftedPoints(const PointSeeds& seeds, const UnitPoint& first);

    UnitPoint operator()(std::uint32_t index) const;

private:
    PointSeeds seeds_{};
    std::array<std::uint32_t, point_dimensions> flipped_{};
};

/// The place of (x, y), each from 0 to 15, on a curve that visits all places of an aligned square
/// of 2^k x 2^k before it leaves the square (Morton 1966).
std::uint32_t place_on_curve(std::uint32_t x, std::uint32_t y);
constexpr int curve_side = 16;

/// Permutes a sequence's points, so that two sequences with the same indices are independent: a
/// random bijection that maps each aligned run of 2^k indices (beginning at a multiple of 2^k) to
/// an aligned run, for k <= 8 (Burley 2020). Each run of 256 indices is mapped to itself.
std::uint32_t shuffled_index(std::uint32_t seed, std::uint32_t index);

/// Maps (u, v) in (0, 1)^2 to two coordinates in [0, 1], preserving area, such that the sum first +
/// ratio*second depends on u only and is monotonic in u. So if the values of u are well
/// distributed, the sums are too.
class SumSplit {
public:
    struct Parts {
        double first, second;
    };

    /// `ratio`: any number, including infinity.
    explicit SumSplit(double ratio = 0);

    Parts operator()(double u, double v) const;

    /// The (u, v) in [0, 1]^2 that is mapped to `parts`. At the ends of the sums' range all v are
    /// mapped to the same parts; inverse() returns one of these v.
    Parts inverse(const Parts& parts) const;

private:
    bool second_is_wide_;
    double narrow_;    // contribution of the narrower coordinate to the sum if the other's is 1;
                       // signed
    double of_narrow_; // 1 / narrow_, or 0
};

} // namespace integral

#endif
