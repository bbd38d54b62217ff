// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/weighed_samples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>

#include "integral/base/vector_loops.h"

namespace integral {

namespace {

/// A sample that does not count, with which the last group is filled up.
const BeamSamples::Sample nobody{};

/// The mean area in which a surface is seen from evenly spread slopes, if that area is between
/// middle - off and middle + off. Where it is below 0 the other side is seen, which counts as 0.
/// `off` must be above 0.
template <class Floats> INTEGRAL_INLINE Floats mean_area(Floats middle, Floats off)
{
    const Floats front = most(middle + off, eight_of<Floats>(0));
    return chosen(middle > off, middle, front * front / (eight_of<Floats>(4) * off));
}

} // namespace

const WeighedSamples::ByNumber WeighedSamples::by_number_ = [] {
    ByNumber by_number{};
    for (std::size_t number = 1; number < by_number.size(); ++number)
        by_number[number] = 1 / std::sqrt(float(number));
    return by_number;
}();

void WeighedSamples::begin(const BeamPatch& patch, const SightSlope& centre,
                           const BeamSamples& samples)
{
    const auto set = [](Eight& all, float one) { std::fill_n(all.values, 8, one); };
    for (int k = 0; k < 2; ++k) {
        const BeamPatch::Axis& axis = patch.axis(k);
        Axis& own = axes_[k];
        const float half_pixel_slope = 0.5f * axis.pixel_slope;
        set(own.cell_at_sheet, axis.cell_at_sheet);
        set(own.cell_slope, axis.cell_slope);
        set(own.pixel_at_sheet, axis.pixel_at_sheet);
        set(own.pixel_slope, axis.pixel_slope);
        set(own.half_pixel_slope, half_pixel_slope);
        set(own.lent_slope, std::max(axis.lent_slope, half_pixel_slope));
        set(own.lent_way, axis.lent_way);
        set(own.centre_point, centre.point[k]);
        set(own.centre_slope, centre.slope[k]);
    }
    tilt_unit_ = samples.tilt_unit();
    number_ = own_number_ = 0;
    patch_ = patch;
}

/// Makes room for that many samples, and for those with which the last group is filled up.
void WeighedSamples::make_room(std::size_t number)
{
    const std::size_t groups = number / 4 + 1;
    added_.resize(8 * groups);
    shares_.resize(groups);
    groups_.resize(groups);
    for (std::vector<float>& column : met_.columns_)
        column.resize(8 * groups + 8);
}

/// Sets a group's lines, depths and shares from eight samples, the `first` one and those after it.
/// `tilts`: BeamSamples::Seen::tilt of these. `light`: the halves of their StoredLight.
template <class Floats>
INTEGRAL_INLINE void WeighedSamples::read(Group& group, Floats (&tilts)[2], Floats (&light)[2],
                                          std::size_t first) const
{
    using Sample = BeamSamples::Sample;
    static_assert(
        sizeof(Sample) == 32 && offsetof(Sample, depth) == 0 && offsetof(Sample, line) == 4 &&
            sizeof(SightSlope) == 16 && offsetof(Sample, tilt) == 20 &&
            offsetof(Sample, light) == 24,
        "a sample is its depth, four numbers of its line, a pair of tilts, and its light");
    FourFloats halves[2][8];
    for (std::size_t i = 0; i < 8; ++i) {
        const char* bytes = reinterpret_cast<const char*>(added_[first + i]);
        std::memcpy(&halves[0][i], bytes, 16);
        std::memcpy(&halves[1][i], bytes + 16, 16);
    }
    Floats numbers[2][4];
    for (std::size_t half = 0; half < 2; ++half) {
        for (std::size_t i = 0; i < 4; ++i)
            numbers[half][i] = of_halves<Floats>(halves[half][i], halves[half][i + 4]);
        transpose(numbers[half]);
    }
    const auto& [depths, point_x, point_y, slope_x] = numbers[0];
    const Floats lean = eight_of<Floats>(patch_.lean()),
                 way_x = point_x - loaded<Floats>(axes_[0].centre_point),
                 turn_x = slope_x - loaded<Floats>(axes_[0].centre_slope);
    store(group.depths, depths);
    store(group.lines[0], way_x);
    store(group.lines[1], point_y - loaded<Floats>(axes_[1].centre_point) - lean * way_x);
    store(group.lines[2], turn_x);
    store(group.lines[3], numbers[1][0] - loaded<Floats>(axes_[1].centre_slope) - lean * turn_x);
    split_pairs(numbers[1][1], tilts[0], tilts[1]);
    tilts[0] = tilts[0] + lean * tilts[1];
    for (Floats& tilt : tilts)
        tilt = eight_of<Floats>(tilt_unit_) * tilt;
    light[0] = numbers[1][2];
    light[1] = numbers[1][3];
    store(group.shares, loaded<Floats>(shares_[first / 8]));
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
        most_off = most_off + tilts[k] * loaded<Floats>(axes_[k].lent_slope);
    }
    store(group.areas, middle);
    if (!any(middle < most_off))
        return one;
    const Floats of_far = one /
                          most(magnitude(loaded<Floats>(group.depths)), eight_of<Floats>(1e-3f));
    Floats own = little, all = little;
    for (int k = 0; k < 2; ++k) {
        const Axis& axis = axes_[k];
        const Floats slope = loaded<Floats>(axis.half_pixel_slope),
                     lent = least(loaded<Floats>(axis.lent_slope),
                                  loaded<Floats>(axis.lent_way) * of_far);
        own = own + tilts[k] * slope;
        all = all + tilts[k] * most(lent, slope);
    }
    return mean_area(middle, own) / most(mean_area(middle, all), little);
}

template <class Floats> INTEGRAL_INLINE void WeighedSamples::weigh_with()
{
    Floats nearest = eight_of<Floats>(1e9f), furthest = eight_of<Floats>(-1e9f),
           sum = eight_of<Floats>(0);
    std::size_t met = 0;
    for (std::size_t k = 0; k < group_number_; ++k) {
        Group& group = groups_[k];
        Floats tilts[2], light[2];
        read(group, tilts, light, 8 * k);
        const auto at = density(group, loaded<Floats>(group.depths));
        const Floats weight = loaded<Floats>(group.shares) * at.value * seen_part(group, tilts);
        store(group.weights, weight);
        const auto counts = weight > eight_of<Floats>(0);
        const unsigned which = bits(counts);
        if (which == 0)
            continue;
        const Floats depths = loaded<Floats>(group.depths);
        nearest = least(nearest, chosen(counts, depths, nearest));
        furthest = most(furthest, chosen(counts, depths, furthest));
        sum = sum + weight;
        const Packing<Floats> packing(which);
        const Floats numbers[Met::all] = {weight, at.x, at.y, depths, light[0], light[1]};
        for (int column = 0; column < Met::all; ++column)
            packing.store(met_.columns_[std::size_t(column)].data() + met, numbers[column]);
        met += std::size_t(__builtin_popcount(which));
    }
    met_.number_ = met;
    for (std::vector<float>& column : met_.columns_)
        std::fill_n(column.data() + met, 8, 0.0f);
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
    if (added_.size() < 8 * group_number_ || groups_.empty())
        make_room(8 * group_number_);
    for (std::size_t k = number_; k < 8 * group_number_; ++k) {
        added_[k] = &nobody;
        shares_[k / 8][k % 8] = 0;
    }
#ifdef INTEGRAL_HAS_AVX2
    if (has_avx2())
        return weigh_with_avx2();
#endif
    weigh_with<TwiceFourFloats>();
}

template <class Floats> INTEGRAL_INLINE float WeighedSamples::variance_with() const
{
    LightSums<Floats> sums, squares;
    for (std::size_t eight = 0; eight < met_.eights(); ++eight) {
        const Floats weights = met_.weights<Floats>(eight);
        for (int pair = 0; pair < 2; ++pair) {
            Floats roots[2];
            met_.root_pair(pair, eight, roots);
            sums.add_pair(pair, weights, roots);
            squares.add_pair(pair, weights, {roots[0] * roots[0], roots[1] * roots[1]});
        }
    }
    const float one = 1 / weight_;
    const FourFloats mean = one * sums.sums(),
                     variance = StoredLight::of_squared_root * (one * squares.sums() - mean * mean);
    return std::max(0.0f, variance[0] + variance[1] + variance[2]);
}

#ifdef INTEGRAL_HAS_AVX2
INTEGRAL_TARGET_AVX2 float WeighedSamples::variance_with_avx2() const
{
    return variance_with<EightFloats>();
}
#endif

float WeighedSamples::variance() const
{
#ifdef INTEGRAL_HAS_AVX2
    if (has_avx2())
        return variance_with_avx2();
#endif
    return variance_with<TwiceFourFloats>();
}

float WeighedSamples::own_part() const
{
    float part = 0;
    for (std::size_t k = 0; k < own_number_; ++k)
        part += groups_[k / 8].weights[k % 8] / weight_;
    return part;
}

float WeighedSamples::part_askew(float depth, const std::array<float, 2>& slopes,
                                 float change) const
{
    float all = 0, askew = 0;
    for (std::size_t k = 0; k < number_; ++k) {
        const float weight = groups_[k / 8].weights[k % 8];
        const BeamSamples::Sample& sample = *added_[k];
        if (!(weight > 0 && sample.depth < depth))
            continue;
        all += weight;
        const float across = sample.tilt[0] + patch_.lean() * sample.tilt[1];
        if (tilt_unit_ * (std::fabs(across) * slopes[0] + std::abs(sample.tilt[1]) * slopes[1]) >=
            change)
            askew += weight;
    }
    return all > 0 ? askew / all : 0;
}

} // namespace integral
