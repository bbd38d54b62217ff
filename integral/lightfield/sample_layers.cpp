// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/sample_layers.h"

#include "integral/lightfield/sample_fit.h"

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

// A layer of less than this part of what is behind it is not looked at closely, and what is behind
// layers that let less than this through is left out.
constexpr float little_part = 0.06f, little_light = 0.01f;

// What a sample tells of where the beam's rays end, if it met a side of a surface that the pixel
// does not see: for a floor that is seen from above and from below that is certain, beside the
// outline of a round thing it is not. Found by trying on sample scenes of POV-Ray's.
constexpr float of_other_side = 0.3f;

/// About the logarithm of x to base 2, for x >= 1: linear between powers of two.
float logarithm(float x)
{
    std::uint32_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return float(bits) * 0x1p-23f - 127;
}

} // namespace

void SampleLayers::begin(const BeamPatch& patch, const SightSlope& centre)
{
    centre_ = FourFloats{centre.point[0], centre.point[1], centre.slope[0], centre.slope[1]};
    for (int k = 0; k < 2; ++k) {
        const BeamPatch::Axis& axis = patch.axis(k);
        cells_[k] = FourFloats{} + axis.cell_at_sheet;
        cell_slopes_[k] = FourFloats{} + axis.cell_slope;
        pixels_[k] = FourFloats{} + axis.pixel_at_sheet;
        pixel_slopes_[k] = FourFloats{} + axis.pixel_slope;
        lent_slopes_[k] = FourFloats{} + std::max(axis.lent_slope, 0.5f * axis.pixel_slope);
        lent_ways_[k] = FourFloats{} + axis.lent_way;
    }
    // The width of a patch grows by this part of itself for each mm.
    steepness_ = patch.axis(0).pixel_slope / patch.axis(0).cell_at_sheet;
    number_ = own_begin_ = own_end_ = 0;
    covers_.clear();
    patch_ = patch;
}

void SampleLayers::add(const BeamSamples& samples, const BeamSamples::Pixel& pixel, float part,
                       bool is_own)
{
    const FourFloats start = FourFloats{pixel.centre.point[0], pixel.centre.point[1],
                                        pixel.centre.slope[0], pixel.centre.slope[1]} -
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
        group.lines[place] = start + units * floats_from(&sample.point);
        group.tilts[0][place] = samples.tilt_unit() * sample.tilt[0];
        group.tilts[1][place] = samples.tilt_unit() * sample.tilt[1];
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
inline SampleLayers::Density SampleLayers::density(const Group& group, FourFloats depth) const
{
    const FourFloats far = magnitude(depth), one = FourFloats{} + 1;
    std::array<FourFloats, 2> places;
    FourFloats value = one;
    for (int k = 0; k < 2; ++k) {
        const FourFloats cell = cells_[k] + cell_slopes_[k] * far,
                         pixel = magnitude(pixels_[k] + pixel_slopes_[k] * depth),
                         place = group.lines[k] + depth * group.lines[k + 2], both = cell + pixel,
                         narrow = least(cell, pixel) + 1e-4f * both;
        places[k] = place / (0.5f * both);
        value *= most(least((0.5f * both - magnitude(place)) / narrow, one), FourFloats{});
    }
    return {places[0], places[1], value};
}

/// The mean area in which a surface is seen from evenly spread slopes, if that area is between
/// middle - off and middle + off. Where it is below 0 the other side is seen, which counts as 0.
/// `off` must be above 0.
inline FourFloats mean_area(FourFloats middle, FourFloats off)
{
    const FourFloats front = most(middle + off, FourFloats{});
    return middle > off ? middle : front * front / (4 * off);
}

/// The area in which each sample's surface is seen from the pixel's slopes, in terms of that from
/// all slopes whose samples count: below 1 for surfaces that are seen nearly edge-on, as a floor
/// far away, which few samples meet at the horizon; 0 for the side that the pixel does not see.
/// Sets the group's areas.
inline FourFloats SampleLayers::seen_part(Group& group) const
{
    const FourFloats one = FourFloats{} + 1;
    std::array<FourFloats, 2> tilts;
    FourFloats most_off{};
    FourFloats& middle = group.areas = one;
    for (int k = 0; k < 2; ++k) {
        tilts[k] = magnitude(group.tilts[k]);
        middle -= group.tilts[k] * group.lines[k + 2];
        most_off += tilts[k] * lent_slopes_[k];
    }
    if (!any(middle < most_off))
        return one;
    const FourFloats far = most(magnitude(group.depths), FourFloats{} + 1e-3f);
    FourFloats own = FourFloats{} + 1e-9f, all = own;
    for (int k = 0; k < 2; ++k) {
        const FourFloats slope = 0.5f * pixel_slopes_[k];
        own += tilts[k] * slope;
        all += tilts[k] * most(least(lent_slopes_[k], lent_ways_[k] / far), slope);
    }
    return mean_area(middle, own) / most(mean_area(middle, all), FourFloats{} + 1e-9f);
}

/// Works out the weights of all samples, and lists those that have one.
void SampleLayers::weigh()
{
    while (number_ % 4 != 0) { // the last group is filled up with samples that do not count
        Group& group = groups_[number_ / 4];
        const std::size_t place = number_++ % 4;
        group.lines[place] = FourFloats{};
        group.depths[place] = group.shares[place] = 0;
        group.tilts[0][place] = group.tilts[1][place] = 0;
    }
    if (met_.size() < number_ + 4)
        met_.resize(2 * number_ + 4);
    met_number_ = 0;
    FourFloats nearest = FourFloats{} + 1e9f, furthest = -nearest, sum{};
    for (std::size_t k = 0; k < number_ / 4; ++k) {
        Group& group = groups_[k];
        transpose(group.lines);
        const Density at = density(group, group.depths);
        const FourFloats weight = group.shares * at.value * seen_part(group);
        group.weights = weight;
        nearest = least(nearest, weight > 0 ? group.depths : nearest);
        furthest = most(furthest, weight > 0 ? group.depths : furthest);
        sum += weight;
        std::array<FourFloats, 4> numbers = {weight, at.x, at.y, group.depths};
        transpose(numbers);
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
            met_[k].layer = std::uint16_t(step_of(met_[k].depth()));
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

/// The light of a sample, times StoredLight::of_squared_root.
inline FourFloats light_of(const StoredLight& light)
{
    const FourFloats roots = floats_from(&light);
    return roots * magnitude(roots);
}

/// Sums up the light of the layers.
void SampleLayers::sum_layers()
{
    for (std::size_t k = 0; k < met_number_; ++k) {
        const Met& met = met_[k];
        Layer& layer = layers_[met.layer];
        layer.weight += met.weight();
        layer.depth += met.weight() * met.depth();
        layer.furthest = std::max(layer.furthest, met.depth());
        layer.light += met.weight() * light_of(met.light);
    }
    for (Layer& layer : layers_)
        layer.depth /= layer.weight;
}

/// The mean square of places in the patch over the beam, along one axis, at a depth.
inline float mean_square(const BeamPatch::Axis& axis, float depth)
{
    const float cell = axis.cell(depth), pixel = axis.pixel(depth), both = cell + std::fabs(pixel);
    return (cell * cell + pixel * pixel) / (3 * both * both);
}

/// The beam's mean light, of all samples that ended in it: of one layer.
FourFloats SampleLayers::fitted() const
{
    SampleFit fit;
    const float depth = 0.5f * (nearest_ + furthest_);
    const FourFloats squares = {0, 0, mean_square(patch_.axis(0), depth),
                                mean_square(patch_.axis(1), depth)},
                     one = FourFloats{} + 1;
    for (std::size_t k = 0; k < met_number_; ++k) {
        const FourFloats numbers = met_[k].numbers,
                         place = __builtin_shufflevector(numbers, numbers, 1, 2, 1, 2),
                         factor = __builtin_shufflevector(numbers, one, 4, 4, 1, 2);
        fit.add(numbers[0], place * factor - squares, light_of(met_[k].light));
    }
    return fit.mean_of_beam();
}

/// The depths at which the samples' surfaces, as planes, are met by lines of the pixel's direction
/// that cross the samples' lines at a depth.
inline FourFloats SampleLayers::seen_depths(const Group& group, FourFloats depth) const
{
    constexpr float tiny = 1e-6f; // where the pixel sees the surface edge-on
    return depth + (group.depths - depth) / (group.areas + tiny);
}

/// The samples that reach a layer inside the beam. `before`: the furthest depth of the layer before
/// it.
ReachingSamples SampleLayers::reaching(const Layer& layer, float before) const
{
    const FourFloats depth = FourFloats{} + layer.depth, none{};
    ReachingSamples result;
    for (std::size_t k = 0; k < number_ / 4; ++k) {
        const Group& group = groups_[k];
        if (!any(group.depths > before))
            continue;
        const Density at = density(group, depth);
        const FourFloats share = group.areas > 0 ? group.shares : of_other_side * group.shares,
                         weight = group.depths > before ? share * at.value : none,
                         passed = seen_depths(group, depth) > layer.furthest ? weight : none;
        if (!(sum_of(weight) > 0))
            continue;
        result.add(weight, weight - passed, at.x, at.y);
        result.passing += covers_.none() ? passed : passed * covers_.open(at.x, at.y);
    }
    return result;
}

/// Reduces a layer's weight and light to what the layers before it let through.
void SampleLayers::see_through_covers(Layer& layer)
{
    const int number = int(&layer - layers_.data());
    covers_.look_from(patch_, layer.depth);
    float weight = 0;
    FourFloats light{};
    for (std::size_t k = 0; k < met_number_; ++k)
        if (met_[k].layer == number) {
            const Met& met = met_[k];
            const float seen = met.weight() * covers_.open(met.numbers[1], met.numbers[2]);
            weight += seen;
            light += seen * light_of(met.light);
        }
    layer.weight = weight;
    layer.light = light;
}

/// The light of all layers, each seen through those before it.
FourFloats SampleLayers::composed()
{
    FourFloats sum{};
    float open = 1, behind = weight_, before = -1e9f; // open: what the layers before let through
    for (Layer& layer : layers_) {
        behind -= layer.weight;
        const bool is_little = layer.weight < little_part * behind;
        float covered = is_little ? layer.weight / (layer.weight + behind) : 1;
        if (!covers_.none())
            see_through_covers(layer);
        if (!is_little && &layer != &layers_.back()) {
            const ReachingSamples samples = reaching(layer, before);
            covered = layer.weight / (layer.weight + sum_of(samples.passing));
            covers_.add(layer.depth, samples);
        }
        sum += open * covered / layer.weight * layer.light;
        open *= 1 - covered;
        before = layer.furthest;
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
    FourFloats light;
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
    return result;
}

float SampleLayers::variance() const
{
    FourFloats sum{}, squares{};
    for (std::size_t k = 0; k < met_number_; ++k) {
        const FourFloats root = floats_from(&met_[k].light),
                         weighted = met_[k].weight() * root;
        sum += weighted;
        squares += weighted * root;
    }
    const FourFloats mean = sum / weight_,
                     variance = StoredLight::of_squared_root * (squares / weight_ - mean * mean);
    return std::max(0.0f, variance[0] + variance[1] + variance[2]);
}

} // namespace integral
