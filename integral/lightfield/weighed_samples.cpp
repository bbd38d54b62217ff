// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/weighed_samples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "integral/base/vector_loops.h"

namespace integral {

namespace {

/// A sample that does not count, with which the last group is filled up.
const BeamSamples::Sample nobody{};

// The density of a beam falls to 0 over the narrower of its two widths, or over this part of both
// together, so that one that has no width does not divide by 0.
constexpr float least_fall = 1e-4f;

/// The mean area in which a surface is seen from evenly spread slopes, if that area is between
/// middle - off and middle + off. Where it is below 0 the other side is seen, which counts as 0.
/// `off` must be above 0.
template <class Floats> INTEGRAL_INLINE Floats mean_area(Floats middle, Floats off)
{
    const Floats front = most(middle + off, eight_of<Floats>(0));
    return chosen(middle > off, middle, front * front / (eight_of<Floats>(4) * off));
}

} // namespace

const WeighedSamples::Shares WeighedSamples::shares_ = [] {
    Shares by_number{};
    for (std::size_t number = 1; number < by_number.size(); ++number)
        by_number[number] = 1 / std::sqrt(float(number));
    return by_number;
}();

void WeighedSamples::begin(const BeamPatch& patch, const SightSlope& centre,
                           const BeamSamples& samples)
{
    centre_ = FourFloats{centre.point[0], centre.point[1], centre.slope[0], centre.slope[1]};
    for (int k = 0; k < 2; ++k) {
        axes_[k] = patch.axis(k);
        axes_[k].lent_slope = std::max(axes_[k].lent_slope, 0.5f * axes_[k].pixel_slope);
    }
    units_ = samples.units();
    number_ = own_begin_ = own_end_ = 0;
    lender_number_ = 0;
    patch_ = patch;
}

/// Sets a group's lines, depths and shares from eight samples, the `first` one and those after it.
/// `tilts`: BeamSamples::Seen::tilt of these.
template <class Floats>
INTEGRAL_INLINE void WeighedSamples::read(Group& group, Floats (&tilts)[2], std::size_t first) const
{
    static_assert(
        offsetof(BeamSamples::Sample, depth) == 0 && offsetof(BeamSamples::Sample, point) == 4 &&
            offsetof(BeamSamples::Sample, slope) == 8 && offsetof(BeamSamples::Sample, tilt) == 12,
        "a sample begins with its depth and three pairs of numbers");
    FourFloats numbers_of[8], starts_of[8];
    for (std::size_t i = 0; i < 8; ++i) {
        const Added& added = added_[first + i];
        const Lender& lender = lenders_[added.lender];
        std::memcpy(&numbers_of[i], added.sample, sizeof numbers_of[i]);
        starts_of[i] = lender.start;
        group.shares[i] = lender.share;
    }
    Floats numbers[4], starts[4];
    for (std::size_t i = 0; i < 4; ++i) {
        numbers[i] = of_halves<Floats>(numbers_of[i], numbers_of[i + 4]);
        starts[i] = of_halves<Floats>(starts_of[i], starts_of[i + 4]);
    }
    transpose(numbers);
    transpose(starts);
    store(group.depths, numbers[0]);
    Floats points[2], slopes[2], pairs[2];
    split_pairs(numbers[1], points[0], points[1]);
    split_pairs(numbers[2], slopes[0], slopes[1]);
    split_pairs(numbers[3], pairs[0], pairs[1]);
    for (int k = 0; k < 2; ++k) {
        store(group.lines[k], starts[k] + eight_of<Floats>(units_.point) * points[k]);
        store(group.lines[k + 2], starts[k + 2] + eight_of<Floats>(units_.slope) * slopes[k]);
        tilts[k] = eight_of<Floats>(units_.tilt) * pairs[k];
    }
}

/// Where eight samples ended. Without branches, which the processor could not predict.
template <class Floats>
INTEGRAL_INLINE WeighedSamples::Density<Floats> WeighedSamples::density(const Group& group) const
{
    const Floats depth = loaded<Floats>(group.depths), far = magnitude(depth),
                 one = eight_of<Floats>(1), none = eight_of<Floats>(0), two = eight_of<Floats>(2);
    Floats places[2], value = one;
    for (int k = 0; k < 2; ++k) {
        const BeamPatch::Axis& axis = axes_[k];
        const Floats cell = eight_of<Floats>(axis.cell_at_sheet) +
                            eight_of<Floats>(axis.cell_slope) * far,
                     pixel = magnitude(eight_of<Floats>(axis.pixel_at_sheet) +
                                       eight_of<Floats>(axis.pixel_slope) * depth),
                     place = loaded<Floats>(group.lines[k]) +
                             depth * loaded<Floats>(group.lines[k + 2]),
                     both = cell + pixel,
                     narrow = least(cell, pixel) + eight_of<Floats>(least_fall) * both,
                     quotient = one / (both * narrow), // one division in place of two
            inside = eight_of<Floats>(0.5f) * both - magnitude(place);
        places[k] = place * (two * narrow * quotient);
        value = value * most(least(inside * (both * quotient), one), none);
    }
    return {places[0], places[1], value};
}

/// The area in which each sample's surface is seen from the pixel's slopes, divided by that from
/// all slopes whose samples count: below 1 for surfaces that are seen nearly edge-on, as a floor
/// far away, which few samples meet at the horizon; 0 for the side that the pixel does not see.
/// Sets the group's areas.
template <class Floats>
INTEGRAL_INLINE Floats WeighedSamples::seen_part(Group& group, Floats (&tilts)[2]) const
{
    const Floats one = eight_of<Floats>(1), little = eight_of<Floats>(1e-9f);
    Floats most_off = eight_of<Floats>(0), middle = one;
    for (int k = 0; k < 2; ++k) {
        middle = middle - tilts[k] * loaded<Floats>(group.lines[k + 2]);
        tilts[k] = magnitude(tilts[k]);
        most_off = most_off + tilts[k] * eight_of<Floats>(axes_[k].lent_slope);
    }
    store(group.areas, middle);
    if (!any(middle < most_off))
        return one;
    const Floats far = most(magnitude(loaded<Floats>(group.depths)), eight_of<Floats>(1e-3f));
    Floats own = little, all = little;
    for (int k = 0; k < 2; ++k) {
        const BeamPatch::Axis& axis = axes_[k];
        const Floats slope = eight_of<Floats>(0.5f * axis.pixel_slope),
                     lent = least(eight_of<Floats>(axis.lent_slope),
                                  eight_of<Floats>(axis.lent_way) / far);
        own = own + tilts[k] * slope;
        all = all + tilts[k] * most(lent, slope);
    }
    return mean_area(middle, own) / most(mean_area(middle, all), little);
}

template <class Floats> INTEGRAL_INLINE void WeighedSamples::weigh_with()
{
    Floats nearest = eight_of<Floats>(1e9f), furthest = eight_of<Floats>(-1e9f),
           sum = eight_of<Floats>(0);
    std::size_t met_number = 0;
    for (std::size_t k = 0; k < group_number_; ++k) {
        Group& group = groups_[k];
        Floats tilts[2];
        read(group, tilts, 8 * k);
        const auto at = density<Floats>(group);
        const Floats weight = loaded<Floats>(group.shares) * at.value * seen_part(group, tilts);
        store(group.weights, weight);
        const auto counts = weight > eight_of<Floats>(0);
        if (!any(counts))
            continue;
        const Floats depths = loaded<Floats>(group.depths);
        nearest = least(nearest, chosen(counts, depths, nearest));
        furthest = most(furthest, chosen(counts, depths, furthest));
        sum = sum + weight;
        Floats numbers[4] = {weight, at.x, at.y, depths};
        transpose(numbers);
        for (std::size_t i = 0; i < 8; ++i) {
            const Floats& both = numbers[i % 4];
            met_[met_number].numbers = i < 4 ? low_half(both) : high_half(both);
            met_[met_number].light = added_[8 * k + i].sample->light;
            met_number += group.weights[i] > 0;
        }
    }
    met_number_ = met_number;
    Eight all_nearest, all_furthest;
    store(all_nearest, nearest);
    store(all_furthest, furthest);
    nearest_ = *std::min_element(all_nearest.values, all_nearest.values + 8);
    furthest_ = *std::max_element(all_furthest.values, all_furthest.values + 8);
    weight_ = sum_of_eight(sum);
}

#ifdef INTEGRAL_HAS_AVX2
INTEGRAL_TARGET_AVX2 void WeighedSamples::weigh_with_avx2() { weigh_with<EightFloats>(); }
#endif

void WeighedSamples::weigh()
{
    group_number_ = (number_ + 7) / 8;
    if (added_.size() < 8 * group_number_)
        added_.resize(8 * group_number_);
    if (groups_.size() < group_number_)
        groups_.resize(2 * group_number_);
    if (met_.size() < 8 * group_number_ + 8)
        met_.resize(16 * group_number_ + 8);
    if (lenders_.size() <= lender_number_)
        lenders_.resize(2 * lender_number_ + 1);
    lenders_[lender_number_] = Lender();
    for (std::size_t k = number_; k < 8 * group_number_; ++k)
        added_[k] = {&nobody, lender_number_};
#ifdef INTEGRAL_HAS_AVX2
    if (has_avx2())
        return weigh_with_avx2();
#endif
    weigh_with<TwiceFourFloats>();
}

float WeighedSamples::own_part() const
{
    float part = 0;
    for (std::size_t k = own_begin_; k < own_end_; ++k)
        part += groups_[k / 8].weights[k % 8] / weight_;
    return part;
}

WeighedSamples::Section::Section(const BeamPatch& patch, float depth) : depth_(depth)
{
    for (int k = 0; k < 2; ++k) {
        const BeamPatch::Axis& axis = patch.axis(k);
        const float cell = axis.cell(depth), pixel = std::fabs(axis.pixel(depth)),
                    both = cell + pixel, narrow = std::min(cell, pixel) + least_fall * both;
        reach_[k] = 0.5f * both;
        of_reach_[k] = 2 / both;
        of_narrow_[k] = 1 / narrow;
    }
}

WeighedSamples::Section WeighedSamples::section(float depth) const { return {patch_, depth}; }

} // namespace integral
