// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/sample_layers.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstring>

namespace integral {

namespace {

// Depths are compared on a scale on which the lines of neighbouring pixels move apart by about a
// patch's width from one number to the next. Two layers have an empty step between them.
constexpr float step = 0.08f;
constexpr int most_steps = 1023;

// The regression is damped as if this many further samples showed no slope (ridge regression), so
// that few samples do not show one by chance. The mean square of a place in the patch is about 0.2.
constexpr float level_samples = 8, square_of_place = 0.2f;

// A layer of less than this part of what is behind it is not looked at closely, and what is behind
// layers that let less than this through is left out.
constexpr float little_part = 0.02f, little_light = 0.004f;

typedef std::int32_t Integers __attribute__((vector_size(16)));

template <class Four> inline Four magnitude(Four x) { return Four(Integers(x) & 0x7fffffff); }
template <class Four> inline Four least(Four a, Four b) { return a < b ? a : b; }
template <class Four> inline Four most(Four a, Four b) { return a > b ? a : b; }
template <class Four> inline float sum_of(Four x) { return (x[0] + x[1]) + (x[2] + x[3]); }

/// About the logarithm of x to base 2, for x >= 1: linear between powers of two.
float logarithm(float x)
{
    std::uint32_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return float(bits) * 0x1p-23f - 127;
}

/// Four 16-bit integers as floats.
template <class Short, class Four> inline Four four(const void* integers)
{
    Short narrow;
    std::memcpy(&narrow, integers, sizeof narrow);
    return __builtin_convertvector(__builtin_convertvector(narrow, Integers), Four);
}
typedef std::int16_t Signed __attribute__((vector_size(8)));
typedef std::uint16_t Unsigned __attribute__((vector_size(8)));

/// Exchanges rows and columns.
template <class Four> inline void turn(std::array<Four, 4>& rows)
{
    const Four a = __builtin_shufflevector(rows[0], rows[1], 0, 4, 1, 5),
               b = __builtin_shufflevector(rows[0], rows[1], 2, 6, 3, 7),
               c = __builtin_shufflevector(rows[2], rows[3], 0, 4, 1, 5),
               d = __builtin_shufflevector(rows[2], rows[3], 2, 6, 3, 7);
    rows = {__builtin_shufflevector(a, c, 0, 1, 4, 5), __builtin_shufflevector(a, c, 2, 3, 6, 7),
            __builtin_shufflevector(b, d, 0, 1, 4, 5), __builtin_shufflevector(b, d, 2, 3, 6, 7)};
}

} // namespace

void SampleLayers::begin(const BeamPatch& patch, const SightSlope& centre)
{
    centre_ = Four{centre.point[0], centre.point[1], centre.slope[0], centre.slope[1]};
    for (int k = 0; k < 2; ++k) {
        const BeamPatch::Axis& axis = patch.axis(k);
        cells_[k] = Four{} + axis.cell_at_sheet;
        cell_slopes_[k] = Four{} + axis.cell_slope;
        pixels_[k] = Four{} + axis.pixel_at_sheet;
        pixel_slopes_[k] = Four{} + axis.pixel_slope;
    }
    // The width of a patch grows by this part of itself for each mm.
    steepness_ = patch.axis(0).pixel_slope / patch.axis(0).cell_at_sheet;
    number_ = own_begin_ = own_end_ = 0;
}

void SampleLayers::add(const BeamSamples& samples, const BeamSamples::Pixel& pixel, float part,
                       bool is_own)
{
    const Four start = Four{pixel.centre.point[0], pixel.centre.point[1], pixel.centre.slope[0],
                            pixel.centre.slope[1]} -
                       centre_,
               units = {samples.point_unit(), samples.point_unit(), samples.slope_unit(),
                        samples.slope_unit()};
    // More samples tell more. But if they counted in full, the mean would lean to where they are.
    const float share = part / std::sqrt(float(pixel.number));
    const std::size_t end = number_ + pixel.number;
    if (4 * groups_.size() < end + 3) // three: see weigh()
        groups_.resize(end);
    const auto add_one = [&](const BeamSamples::Sample& sample) {
        Group& group = groups_[number_ / 4];
        const std::size_t place = number_++ % 4;
        group.lines[place] = start + units * four<Signed, Four>(&sample.point);
        group.depths[place] = sample.depth;
        group.shares[place] = share;
        group.light[place] = sample.light;
    };
    if (is_own) {
        own_begin_ = number_;
        own_end_ = end;
    }
    add_one(pixel.first);
    for (int k = 0; k + 1 < pixel.number; ++k)
        add_one(pixel.more[k]);
}

/// Where the lines of four samples are at a depth. Without branches, which the processor could not
/// predict.
inline SampleLayers::Density SampleLayers::density(const Group& group, Four depth) const
{
    const Four far = magnitude(depth), one = Four{} + 1;
    std::array<Four, 2> places;
    Four value = one;
    for (int k = 0; k < 2; ++k) {
        const Four cell = cells_[k] + cell_slopes_[k] * far,
                   pixel = magnitude(pixels_[k] + pixel_slopes_[k] * depth),
                   place = group.lines[k] + depth * group.lines[k + 2], both = cell + pixel,
                   narrow = least(cell, pixel) + 1e-4f * both;
        places[k] = place / (0.5f * both);
        value *= most(least((0.5f * both - magnitude(place)) / narrow, one), Four{});
    }
    return {places[0], places[1], value};
}

/// Works out the weights of all samples, and lists those that have one.
void SampleLayers::weigh()
{
    while (number_ % 4 != 0) { // the last group is filled up with samples that do not count
        Group& group = groups_[number_ / 4];
        const std::size_t place = number_++ % 4;
        group.lines[place] = Four{};
        group.depths[place] = group.shares[place] = 0;
    }
    if (met_.size() < number_ + 4)
        met_.resize(2 * number_ + 4);
    met_number_ = 0;
    Four nearest = Four{} + 1e9f, furthest = -nearest, sum{};
    for (std::size_t k = 0; k < number_ / 4; ++k) {
        Group& group = groups_[k];
        turn(group.lines);
        const Density at = density(group, group.depths);
        const Four weight = group.shares * at.value;
        group.weights = weight;
        nearest = least(nearest, weight > 0 ? group.depths : nearest);
        furthest = most(furthest, weight > 0 ? group.depths : furthest);
        sum += weight;
        std::array<Four, 4> numbers = {weight, at.x, at.y, group.depths};
        turn(numbers);
        for (int i = 0; i < 4; ++i) {
            met_[met_number_].numbers = numbers[i];
            met_[met_number_].light = group.light[i];
            met_number_ += weight[i] > 0;
        }
    }
    nearest_ = std::min({nearest[0], nearest[1], nearest[2], nearest[3]});
    furthest_ = std::max({furthest[0], furthest[1], furthest[2], furthest[3]});
    weight_ = sum_of(sum);
}

/// A depth on the scale on which layers are told apart.
inline float SampleLayers::scaled(float depth) const
{
    const float value = 2.2f * logarithm(1 + std::fabs(depth) * steepness_);
    return depth < 0 ? -value : value;
}

/// Divides the samples that ended in the beam into layers, from the viewer on.
void SampleLayers::find_layers()
{
    layers_.clear();
    const float begin = scaled(nearest_);
    const auto step_of = [&](float depth) {
        return std::min(most_steps, int((scaled(depth) - begin) * (1 / step)));
    };
    const int last = step_of(furthest_);
    std::bitset<most_steps + 1> used;
    if (last >= 2)
        for (std::size_t k = 0; k < met_number_; ++k) {
            met_[k].layer = std::uint16_t(step_of(met_[k].numbers[3]));
            used.set(met_[k].layer);
        }
    std::array<std::uint16_t, most_steps + 1> layer_of;
    for (int k = 0; k <= last; ++k)
        if (used[k]) {
            if (k == 0 || !used[k - 1])
                layers_.emplace_back();
            layer_of[k] = std::uint16_t(layers_.size() - 1);
        }
    if (layers_.size() > 1)
        for (std::size_t k = 0; k < met_number_; ++k)
            met_[k].layer = layer_of[met_[k].layer];
}

/// Sums up the light of the layers.
void SampleLayers::sum_layers()
{
    light_ = roots_ = Four{};
    for (std::size_t k = 0; k < met_number_; ++k) {
        const Met& met = met_[k];
        Layer& layer = layers_[met.layer];
        const float weight = met.numbers[0], depth = met.numbers[3];
        const Four roots = four<Unsigned, Four>(&met.light), light = weight * (roots * roots);
        layer.weight += weight;
        layer.depth += weight * depth;
        layer.furthest = std::max(layer.furthest, depth);
        layer.light += light;
        light_ += light;
        roots_ += weight * roots;
    }
}

/// The light at the middle of the patch, of a straight line through all samples.
SampleLayers::Four SampleLayers::fitted()
{
    Four light{}, roots_sum{}, light_x{}, light_y{}, squares{}, by_x{}, by_y{};
    for (std::size_t k = 0; k < met_number_; ++k) {
        const Four numbers = met_[k].numbers, roots = four<Unsigned, Four>(&met_[k].light),
                   weighted = numbers[0] * numbers, own = numbers[0] * (roots * roots);
        roots_sum += numbers[0] * roots;
        light += own;
        light_x += numbers[1] * own;
        light_y += numbers[2] * own;
        squares += weighted;
        by_x += numbers[1] * weighted;
        by_y += numbers[2] * weighted;
    }
    light_ = light;
    roots_ = roots_sum;
    const float one = 1 / weight_;
    const Four mean = one * light;
    // `squares` begins with that of the weights, which tells as how many even samples they count.
    const float x = one * squares[1], y = one * squares[2],
                level = square_of_place * level_samples * squares[0] * one * one,
                xx = one * by_x[1] - x * x + level, yy = one * by_y[2] - y * y + level,
                xy = one * by_x[2] - x * y, of_determinant = 1 / (xx * yy - xy * xy);
    const Four to_x = one * light_x - x * mean, to_y = one * light_y - y * mean,
               slope_x = of_determinant * (yy * to_x - xy * to_y),
               slope_y = of_determinant * (xx * to_y - xy * to_x);
    return most(mean - x * slope_x - y * slope_y, Four{});
}

/// The weight of the samples that pass a layer inside the beam.
float SampleLayers::passing(const Layer& layer) const
{
    const Four depth = Four{} + layer.depth / layer.weight;
    Four sum{};
    for (std::size_t k = 0; k < number_ / 4; ++k) {
        const Group& group = groups_[k];
        const Four passed = group.shares * density(group, depth).value;
        sum += group.depths > layer.furthest ? passed : Four{};
    }
    return sum_of(sum);
}

/// The light of all layers, each seen through those before it.
SampleLayers::Four SampleLayers::composed() const
{
    Four sum{};
    float open = 1, behind = weight_; // what the layers before let through
    for (const Layer& layer : layers_) {
        behind -= layer.weight;
        const bool little = layer.weight < little_part * behind;
        const float covered = &layer == &layers_.back()
                                  ? 1
                                  : layer.weight /
                                        (layer.weight + (little ? behind : passing(layer)));
        sum += open * covered / layer.weight * layer.light;
        open *= 1 - covered;
        if (open < little_light)
            break;
    }
    return sum;
}

std::optional<SampleLayers::Light> SampleLayers::light()
{
    weigh();
    if (!(weight_ > 0))
        return {};
    find_layers();
    Four light;
    if (layers_.size() > 1) {
        sum_layers();
        light = composed();
    } else
        light = fitted();
    light *= StoredLight::of_squared_root;
    Light result;
    std::memcpy(&result.light, &light, sizeof light);
    for (std::size_t k = own_begin_; k < own_end_; ++k)
        result.own_part += groups_[k / 4].weights[k % 4] / weight_;
    const Four mean = roots_ / weight_,
               variance = StoredLight::of_squared_root * (light_ / weight_ - mean * mean);
    result.variance = std::max(0.0f, variance[0] + variance[1] + variance[2]);
    return result;
}

} // namespace integral
