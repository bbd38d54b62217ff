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
constexpr float step = 0.3f;
constexpr int most_steps = 255;

typedef std::int32_t Integers __attribute__((vector_size(16)));

template <class Four> inline Four magnitude(Four x) { return Four(Integers(x) & 0x7fffffff); }
template <class Four> inline Four least(Four a, Four b) { return a < b ? a : b; }
template <class Four> inline Four most(Four a, Four b) { return a > b ? a : b; }
template <class Four> inline float sum_of(Four x) { return (x[0] + x[1]) + (x[2] + x[3]); }

/// About the logarithms of four numbers to base 2, each at least 1: linear between powers of two.
template <class Four> inline Four logarithm(Four x)
{
    return __builtin_convertvector(Integers(x), Four) * 0x1p-23f - 127;
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

template <class Four> inline Four loaded(const std::array<float, 4>& numbers)
{
    Four result;
    std::memcpy(&result, &numbers, sizeof result);
    return result;
}

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

void SampleLayers::add(const BeamSamples& samples, const BeamSamples::Pixel& pixel, bool is_own)
{
    const Four start = Four{pixel.centre.point[0], pixel.centre.point[1], pixel.centre.slope[0],
                            pixel.centre.slope[1]} -
                       centre_,
               units = {samples.point_unit(), samples.point_unit(), samples.slope_unit(),
                        samples.slope_unit()};
    const float share = 1.0f / float(pixel.number);
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

/// The density of the beam where the lines of four samples are at a depth, in terms of the greatest
/// density there. Without branches, which the processor could not predict.
inline SampleLayers::Four SampleLayers::density(const Group& group, Four depth) const
{
    const Four far = magnitude(depth), one = Four{} + 1;
    Four result = one;
    for (int k = 0; k < 2; ++k) {
        const Four cell = cells_[k] + cell_slopes_[k] * far,
                   pixel = magnitude(pixels_[k] + pixel_slopes_[k] * depth),
                   place = magnitude(group.lines[k] + depth * group.lines[k + 2]),
                   both = cell + pixel, narrow = least(cell, pixel) + 1e-4f * both;
        result *= most(least((0.5f * both - place) / narrow, one), Four{});
    }
    return result;
}

/// Works out the weights of all samples, their sum, and the depths of those that have one.
void SampleLayers::weigh()
{
    while (number_ % 4 != 0) { // the last group is filled up with samples that do not count
        Group& group = groups_[number_ / 4];
        const std::size_t place = number_++ % 4;
        group.lines[place] = Four{};
        group.depths[place] = group.shares[place] = 0;
        group.light[place] = StoredLight(LinearColour{});
    }
    Four nearest = Four{} + 1e9f, furthest = -nearest, sum{};
    for (std::size_t k = 0; k < number_ / 4; ++k) {
        Group& group = groups_[k];
        turn(group.lines);
        const Four depth = loaded<Four>(group.depths),
                   weight = loaded<Four>(group.shares) * density(group, depth);
        nearest = least(nearest, weight > 0 ? depth : nearest);
        furthest = most(furthest, weight > 0 ? depth : furthest);
        sum += weight;
        std::memcpy(&group.weights, &weight, sizeof weight);
    }
    nearest_ = std::min({nearest[0], nearest[1], nearest[2], nearest[3]});
    furthest_ = std::max({furthest[0], furthest[1], furthest[2], furthest[3]});
    weight_ = sum_of(sum);
}

/// Depths on the scale on which layers are told apart.
inline SampleLayers::Four SampleLayers::scaled(Four depth) const
{
    const Four value = 2.2f * logarithm(1 + magnitude(depth) * steepness_);
    return depth < 0 ? -value : value;
}

/// Divides the depths of the samples that ended in the beam into layers, from the viewer on.
void SampleLayers::find_layers()
{
    layers_.clear();
    const Four ends = scaled(Four{nearest_, furthest_, 0, 0});
    const float last = (ends[1] - ends[0]) * (1 / step);
    if (last < 2) {
        layers_.emplace_back();
        return;
    }
    std::bitset<most_steps + 1> used;
    for (std::size_t k = 0; k < number_ / 4; ++k) {
        Group& group = groups_[k];
        Four steps = (scaled(loaded<Four>(group.depths)) - ends[0]) * (1 / step);
        steps = least(steps, Four{} + most_steps);
        steps = loaded<Four>(group.weights) > 0 ? steps : Four{};
        const Integers numbers = __builtin_convertvector(steps, Integers);
        for (int i = 0; i < 4; ++i) {
            group.layers[i] = std::uint16_t(numbers[i]);
            used.set(group.layers[i]);
        }
    }
    std::array<std::uint16_t, most_steps + 1> layer_of;
    for (int k = 0; k <= most_steps; ++k)
        if (used[k]) {
            if (k == 0 || !used[k - 1])
                layers_.emplace_back();
            layer_of[k] = std::uint16_t(layers_.size() - 1);
        }
    if (layers_.size() > 1)
        for (std::size_t k = 0; k < number_ / 4; ++k)
            for (std::uint16_t& layer : groups_[k].layers)
                layer = layer_of[layer];
}

/// Sums up the light of the layers.
void SampleLayers::sum_light()
{
    roots_ = Four{};
    const auto for_each = [&](auto add) {
        for (std::size_t k = 0; k < number_ / 4; ++k)
            for (int i = 0; i < 4; ++i)
                add(groups_[k], i, groups_[k].weights[i],
                    four<Unsigned, Four>(&groups_[k].light[i]));
    };
    if (layers_.size() == 1) {
        Four light{}, all_roots{};
        for_each([&](const Group&, int, float weight, Four roots) {
            all_roots += weight * roots;
            light += weight * (roots * roots);
        });
        layers_[0].weight = weight_;
        layers_[0].light = light;
        roots_ = all_roots;
        return;
    }
    for_each([&](const Group& group, int i, float weight, Four roots) {
        Layer& layer = layers_[group.layers[i]];
        layer.weight += weight;
        layer.depth += weight * group.depths[i];
        layer.furthest = std::max(layer.furthest, weight > 0 ? group.depths[i] : layer.furthest);
        layer.light += weight * (roots * roots);
        roots_ += weight * roots;
    });
}

/// The weight of the samples that pass a layer inside the beam.
float SampleLayers::passing(const Layer& layer) const
{
    const Four depth = Four{} + layer.depth / layer.weight;
    Four sum{};
    for (std::size_t k = 0; k < number_ / 4; ++k) {
        const Group& group = groups_[k];
        const Four passed = loaded<Four>(group.shares) * density(group, depth);
        sum += loaded<Four>(group.depths) > layer.furthest ? passed : Four{};
    }
    return sum_of(sum);
}

std::optional<SampleLayers::Light> SampleLayers::light()
{
    weigh();
    if (!(weight_ > 0))
        return {};
    find_layers();
    sum_light();
    Light result;
    for (std::size_t k = own_begin_; k < own_end_; ++k)
        result.own_part += groups_[k / 4].weights[k % 4] / weight_;
    Four sum{}, squares{};
    float open = 1; // what the layers before let through
    for (std::size_t k = 0; k < layers_.size(); ++k) {
        const Layer& layer = layers_[k];
        const bool last = k + 1 == layers_.size();
        const float covered = last ? 1 : layer.weight / (layer.weight + passing(layer));
        sum += open * covered / layer.weight * layer.light;
        squares += layer.light;
        open *= 1 - covered;
    }
    sum *= StoredLight::of_squared_root;
    std::memcpy(&result.light, &sum, sizeof sum);
    const Four mean = roots_ / weight_,
               variance = StoredLight::of_squared_root * (squares / weight_ - mean * mean);
    result.variance = std::max(0.0f, variance[0] + variance[1] + variance[2]);
    return result;
}

} // namespace integral
