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
constexpr int most_steps = 256;

/// About the logarithm of x to base 2, for x >= 1: linear between powers of two.
float logarithm(float x)
{
    std::uint32_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return float(bits) * 0x1p-23f - 127;
}

typedef std::int32_t Bits __attribute__((vector_size(16)));
template <class Four> inline Four magnitude(Four x) { return Four(Bits(x) & 0x7fffffff); }

inline float least(float a, float b) { return a < b ? a : b; }
inline float most(float a, float b) { return a > b ? a : b; }

/// Four 16-bit integers as floats.
template <class Integers, class Four> inline Four four(const void* integers)
{
    typedef std::int32_t Wide __attribute__((vector_size(16)));
    Integers narrow;
    std::memcpy(&narrow, integers, sizeof narrow);
    return __builtin_convertvector(__builtin_convertvector(narrow, Wide), Four);
}

typedef std::int16_t Signed __attribute__((vector_size(8)));
typedef std::uint16_t Unsigned __attribute__((vector_size(8)));

} // namespace

void SampleLayers::begin(const BeamPatch& patch, const SightSlope& centre)
{
    centre_ = Four{centre.point[0], centre.point[1], centre.slope[0], centre.slope[1]};
    const BeamPatch::Axis &across = patch.axis(0), &along = patch.axis(1);
    widths_ = Four{across.cell_at_sheet, along.cell_at_sheet, across.pixel_at_sheet,
                   along.pixel_at_sheet};
    width_slopes_ = Four{across.cell_slope, along.cell_slope, across.pixel_slope,
                         along.pixel_slope};
    // The width of a patch grows by this part of itself for each mm.
    steepness_ = across.pixel_slope / across.cell_at_sheet;
    number_ = 0;
    all_ = Layer{1e9f, -1e9f};
    own_ = 0;
}

/// The density of the beam where a line is at a depth, in terms of the greatest density there.
/// Without branches, which the processor could not predict.
inline float SampleLayers::density(Four line, float depth) const
{
    const float far = std::fabs(depth);
    const Four widths = magnitude(widths_ + width_slopes_ * Four{far, far, depth, depth}),
               place = magnitude(line + depth * Four{line[2], line[3], 0, 0}),
               pixel = {widths[2], widths[3], 1, 1}, both = widths + pixel;
    const Four narrow = (widths < pixel ? widths : pixel) + 1e-4f * both;
    Four part = (0.5f * both - place) / narrow;
    part = part < 1 ? part : Four{1, 1, 1, 1};
    part = part > 0 ? part : Four{};
    return part[0] * part[1];
}

/// A depth on the scale on which layers are told apart.
float SampleLayers::scaled(float depth) const
{
    const float value = 2.2f * logarithm(1 + std::fabs(depth) * steepness_);
    return depth < 0 ? -value : value;
}

inline void SampleLayers::Layer::add(const Entry& entry)
{
    const bool counts = entry.weight > 0;
    nearest = least(nearest, counts ? entry.depth : nearest);
    furthest = most(furthest, counts ? entry.depth : furthest);
    weight += entry.weight;
    depth += entry.weight * entry.depth;
    const Four own = four<Unsigned, Four>(&entry.light);
    roots += entry.weight * own;
    light += entry.weight * (own * own);
}

void SampleLayers::add(const BeamSamples& samples, const BeamSamples::Pixel& pixel, bool is_own)
{
    const Four start = Four{pixel.centre.point[0], pixel.centre.point[1], pixel.centre.slope[0],
                            pixel.centre.slope[1]} -
                       centre_,
               units = {samples.point_unit(), samples.point_unit(), samples.slope_unit(),
                        samples.slope_unit()};
    const float share = 1.0f / float(pixel.number);
    if (entries_.size() < number_ + pixel.number)
        entries_.resize(2 * (number_ + pixel.number));
    Layer all = all_;
    const auto add_one = [&](const BeamSamples::Sample& sample) {
        Entry& entry = entries_[number_++];
        entry.line = start + units * four<Signed, Four>(&sample.point);
        entry.depth = sample.depth;
        entry.share = share;
        entry.weight = share * density(entry.line, entry.depth);
        entry.light = sample.light;
        all.add(entry);
    };
    add_one(pixel.first);
    for (int k = 0; k + 1 < pixel.number; ++k)
        add_one(pixel.more[k]);
    if (is_own)
        own_ += all.weight - all_.weight;
    all_ = all;
}

/// Divides the depths of the samples that ended in the beam into layers, from the viewer on.
void SampleLayers::find_layers()
{
    layers_.clear();
    const float begin = scaled(all_.nearest);
    const auto step_of = [&](float depth) {
        return std::min(most_steps, int((scaled(depth) - begin) * (1 / step)));
    };
    const int last = step_of(all_.furthest);
    if (last <= 1) {
        layers_.push_back(all_);
        return;
    }
    std::bitset<most_steps + 1> used;
    for (std::size_t k = 0; k < number_; ++k)
        if (entries_[k].weight > 0)
            used.set(step_of(entries_[k].depth));
    std::array<std::int16_t, most_steps + 1> layer_of;
    for (int k = 0; k <= last; ++k)
        if (used[k]) {
            if (k == 0 || !used[k - 1])
                layers_.push_back({1e9f, -1e9f});
            layer_of[k] = std::int16_t(layers_.size() - 1);
        }
    if (layers_.size() == 1) {
        layers_[0] = all_;
        return;
    }
    for (std::size_t k = 0; k < number_; ++k)
        if (entries_[k].weight > 0)
            layers_[layer_of[step_of(entries_[k].depth)]].add(entries_[k]);
}

/// The weight of the samples that pass a layer inside the beam.
float SampleLayers::passing(const Layer& layer) const
{
    const float depth = layer.depth / layer.weight;
    float sum = 0;
    for (std::size_t k = 0; k < number_; ++k)
        if (entries_[k].depth > layer.furthest)
            sum += entries_[k].share * density(entries_[k].line, depth);
    return sum;
}

std::optional<SampleLayers::Light> SampleLayers::light()
{
    if (!(all_.weight > 0))
        return {};
    Light result;
    result.own_part = own_ / all_.weight;
    find_layers();
    Four sum{};
    float open = 1; // what the layers before let through
    for (std::size_t k = 0; k < layers_.size(); ++k) {
        const Layer& layer = layers_[k];
        const bool last = k + 1 == layers_.size();
        const float covered = last ? 1 : layer.weight / (layer.weight + passing(layer));
        sum += open * covered / layer.weight * layer.light;
        open *= 1 - covered;
    }
    sum *= StoredLight::of_squared_root;
    std::memcpy(&result.light, &sum, sizeof sum);
    const Four mean = all_.roots / all_.weight,
               variance = StoredLight::of_squared_root * (all_.light / all_.weight - mean * mean);
    result.variance = most(0, variance[0] + variance[1] + variance[2]);
    return result;
}

} // namespace integral
