// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/reconstruction/weighted_samples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>

#include "integral/base/vector_loops.h"

namespace integral {

namespace {

/// A sample that does not count, as padding of the last group.
const BeamSamples::Sample no_sample{};

/// Mean projected area of a surface over a range of slopes in which the area grows linearly from
/// middle - off to middle + off. An area below 0 is that of the other side and counts as 0. `off`
/// must be above 0.
template <class Floats> INTEGRAL_INLINE Floats mean_area(Floats middle, Floats off)
{
    const Floats front = max(middle + off, broadcast<Floats>(0));
    return select(middle > off, middle, front * front / (broadcast<Floats>(4) * off));
}

} // namespace

const WeightedSamples::ByNumber WeightedSamples::by_number_ = [] {
    ByNumber by_number{};
    for (std::size_t number = 1; number < by_number.size(); ++number)
        by_number[number] = 1 / std::sqrt(float(number));
    return by_number;
}();

void WeightedSamples::begin(const BeamFootprint& patch, const LightFieldRay& centre,
                            const BeamSamples& samples)
{
    const auto set = [](Eight& all, float one) { std::fill_n(all.values, 8, one); };
    for (int k = 0; k < 2; ++k) {
        const BeamFootprint::Axis& axis = patch.axis(k);
        Axis& own = axes_[k];
        const float half_pixel_slope = 0.5f * axis.pixel_slope;
        set(own.cell_at_sheet, axis.cell_at_sheet);
        set(own.cell_slope, axis.cell_slope);
        set(own.pixel_at_sheet, axis.pixel_at_sheet);
        set(own.pixel_slope, axis.pixel_slope);
        set(own.half_pixel_slope, half_pixel_slope);
        set(own.max_slope_offset, std::max(axis.max_slope_offset, half_pixel_slope));
        set(own.max_lens_distance, axis.max_lens_distance);
        set(own.centre_point, centre.point[k]);
        set(own.centre_slope, centre.slope[k]);
    }
    tilt_unit_ = samples.tilt_unit();
    number_ = own_number_ = 0;
    patch_ = patch;
}

/// Makes room for `number` samples and the padding of the last group.
void WeightedSamples::make_room(std::size_t number)
{
    const std::size_t groups = number / 4 + 1;
    added_.resize(8 * groups);
    shares_.resize(groups);
    groups_.resize(groups);
    for (std::vector<float>& column : met_.columns_)
        column.resize(8 * groups + 8);
}

/// Sets a group's lines, depths and shares from the eight samples from index `first` on. `tilts`:
/// gets the samples' BeamSamples::Seen::tilt. `light`: gets the halves of their StoredLight.
template <class Floats>
INTEGRAL_INLINE void WeightedSamples::read(Group& group, Floats (&tilts)[2], Floats (&light)[2],
                                           std::size_t first) const
{
    using Sample = BeamSamples::Sample;
    static_assert(
        sizeof(Sample) == 32 && offsetof(Sample, depth) == 0 && offsetof(Sample, line) == 4 &&
            sizeof(LightFieldRay) == 16 && offsetof(Sample, tilt) == 20 &&
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
    const Floats lean = broadcast<Floats>(patch_.lean()),
                 way_x = point_x - load<Floats>(axes_[0].centre_point),
                 turn_x = slope_x - load<Floats>(axes_[0].centre_slope);
    store(group.depths, depths);
    store(group.lines[0], way_x);
    store(group.lines[1], point_y - load<Floats>(axes_[1].centre_point) - lean * way_x);
    store(group.lines[2], turn_x);
    store(group.lines[3], numbers[1][0] - load<Floats>(axes_[1].centre_slope) - lean * turn_x);
    split_pairs(numbers[1][1], tilts[0], tilts[1]);
    tilts[0] = tilts[0] + lean * tilts[1];
    for (Floats& tilt : tilts)
        tilt = broadcast<Floats>(tilt_unit_) * tilt;
    light[0] = numbers[1][2];
    light[1] = numbers[1][3];
    store(group.shares, load<Floats>(shares_[first / 8]));
}

/// For each sample's surface, its mean projected area over the pixel's slopes divided by that over
/// all slopes whose samples count. This ratio is below 1 for surfaces that are seen nearly edge-on,
/// such as a floor far away, which few samples meet at the horizon; it is 0 for a side that the
/// pixel does not see. Sets the group's areas.
template <class Floats>
INTEGRAL_INLINE Floats WeightedSamples::seen_part(Group& group, Floats (&tilts)[2]) const
{
    const Floats one = broadcast<Floats>(1), little = broadcast<Floats>(1e-9f);
    Floats most_off = broadcast<Floats>(0), middle = one;
    for (int k = 0; k < 2; ++k) {
        middle = middle - tilts[k] * load<Floats>(group.lines[k + 2]);
        tilts[k] = abs(tilts[k]);
        most_off = most_off + tilts[k] * load<Floats>(axes_[k].max_slope_offset);
    }
    store(group.areas, middle);
    if (!any(middle < most_off))
        return one;
    const Floats of_far = one / max(abs(load<Floats>(group.depths)), broadcast<Floats>(1e-3f));
    Floats own = little, all = little;
    for (int k = 0; k < 2; ++k) {
        const Axis& axis = axes_[k];
        const Floats slope = load<Floats>(axis.half_pixel_slope),
                     lent = min(load<Floats>(axis.max_slope_offset),
                                load<Floats>(axis.max_lens_distance) * of_far);
        own = own + tilts[k] * slope;
        all = all + tilts[k] * max(lent, slope);
    }
    return mean_area(middle, own) / max(mean_area(middle, all), little);
}

template <class Floats> INTEGRAL_INLINE void WeightedSamples::weigh_with()
{
    Floats nearest = broadcast<Floats>(1e9f), furthest = broadcast<Floats>(-1e9f),
           sum = broadcast<Floats>(0);
    std::size_t hits = 0;
    for (std::size_t k = 0; k < group_number_; ++k) {
        Group& group = groups_[k];
        Floats tilts[2], light[2];
        read(group, tilts, light, 8 * k);
        const auto at = density(group, load<Floats>(group.depths));
        const Floats weight = load<Floats>(group.shares) * at.value * seen_part(group, tilts);
        store(group.weights, weight);
        const auto counts = weight > broadcast<Floats>(0);
        const unsigned which = bits(counts);
        if (which == 0)
            continue;
        const Floats depths = load<Floats>(group.depths);
        nearest = min(nearest, select(counts, depths, nearest));
        furthest = max(furthest, select(counts, depths, furthest));
        sum = sum + weight;
        const Packing<Floats> packing(which);
        const Floats numbers[HitSamples::all] = {weight, at.x, at.y, depths, light[0], light[1]};
        for (int column = 0; column < HitSamples::all; ++column)
            packing.store(met_.columns_[std::size_t(column)].data() + hits, numbers[column]);
        hits += std::size_t(__builtin_popcount(which));
    }
    met_.number_ = hits;
    for (std::vector<float>& column : met_.columns_)
        std::fill_n(column.data() + hits, 8, 0.0f);
    Eight all_nearest, all_furthest;
    store(all_nearest, nearest);
    store(all_furthest, furthest);
    nearest_ = *std::min_element(all_nearest.values, all_nearest.values + 8);
    furthest_ = *std::max_element(all_furthest.values, all_furthest.values + 8);
    weight_ = sum_of_eight(sum);
}

#ifdef INTEGRAL_HAS_AVX2
INTEGRAL_TARGET_AVX2 void WeightedSamples::weigh_with_avx2() { weigh_with<EightFloats>(); }
#endif

void WeightedSamples::weigh()
{
    group_number_ = (number_ + 7) / 8;
    if (added_.size() < 8 * group_number_ || groups_.empty())
        make_room(8 * group_number_);
    for (std::size_t k = number_; k < 8 * group_number_; ++k) {
        added_[k] = &no_sample;
        shares_[k / 8][k % 8] = 0;
    }
#ifdef INTEGRAL_HAS_AVX2
    if (has_avx2())
        return weigh_with_avx2();
#endif
    weigh_with<TwiceFourFloats>();
}

template <class Floats> INTEGRAL_INLINE float WeightedSamples::variance_with() const
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
INTEGRAL_TARGET_AVX2 float WeightedSamples::variance_with_avx2() const
{
    return variance_with<EightFloats>();
}
#endif

float WeightedSamples::variance() const
{
#ifdef INTEGRAL_HAS_AVX2
    if (has_avx2())
        return variance_with_avx2();
#endif
    return variance_with<TwiceFourFloats>();
}

float WeightedSamples::own_part() const
{
    float part = 0;
    for (std::size_t k = 0; k < own_number_; ++k)
        part += groups_[k / 8].weights[k % 8] / weight_;
    return part;
}

float WeightedSamples::part_askew(float depth, const std::array<float, 2>& slopes,
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
