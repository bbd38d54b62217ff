// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/sample_layers.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "integral/base/vector_loops.h"

namespace integral {

using Met = WeighedSamples::Met;

namespace {

// Depths are compared on a scale on which the lines of neighbouring pixels move apart by about a
// patch's width from one number to the next. Two layers have an empty step between them.
constexpr float step = 0.08f;

// A layer of less than this part of what is behind it is not looked at closely, and what is behind
// layers that let less than this through is left out.
constexpr float little_part = 0.06f, little_light = 0.01f;

/// About the logarithm of x to base 2, for x >= 1: linear between powers of two.
template <class Floats> INTEGRAL_INLINE Floats logarithm(Floats x)
{
    return bits_as_number(x) * eight_of<Floats>(0x1p-23f) - eight_of<Floats>(127);
}

} // namespace

/// A depth on the scale on which layers are told apart.
template <class Floats> INTEGRAL_INLINE Floats SampleLayers::scaled(Floats depth) const
{
    const Floats one = eight_of<Floats>(1), none = eight_of<Floats>(0),
                 value = eight_of<Floats>(2.2f) *
                         logarithm(one + magnitude(depth) * eight_of<Floats>(steepness_));
    return chosen(depth < none, none - value, value);
}

/// Sets each sample's layer to its step on the scale, counted from the nearest one's. Adds them
/// to `steps`.
template <class Floats> INTEGRAL_INLINE void SampleLayers::find_steps_with(Steps& steps)
{
    const Floats begin = eight_of<Floats>(scaled(samples_.nearest())),
                 last = eight_of<Floats>(most_steps), of_step = eight_of<Floats>(1 / step);
    const auto all = samples_.met();
    for (Met* met = all.begin(); met < all.end(); met += 8) {
        Floats numbers[4];
        for (int i = 0; i < 4; ++i)
            numbers[i] = of_halves<Floats>(met[i].numbers, met[i + 4].numbers);
        transpose(numbers);
        Eight found;
        store(found, least((scaled(numbers[3]) - begin) * of_step, last));
        for (std::size_t i = 0; i < 8 && met + i < all.end(); ++i) {
            met[i].layer = std::uint16_t(int(found[i]));
            steps[met[i].layer / 64] |= std::uint64_t(1) << met[i].layer % 64;
        }
    }
}

#ifdef INTEGRAL_HAS_AVX2
INTEGRAL_TARGET_AVX2 void SampleLayers::find_steps_with_avx2(Steps& steps)
{
    find_steps_with<EightFloats>(steps);
}
#endif

void SampleLayers::find_steps(Steps& steps)
{
#ifdef INTEGRAL_HAS_AVX2
    if (has_avx2())
        return find_steps_with_avx2(steps);
#endif
    find_steps_with<TwiceFourFloats>(steps);
}

/// Divides the samples that ended in the beam into layers, from the viewer on.
void SampleLayers::find_layers()
{
    layers_.clear();
    const float range = scaled(samples_.furthest()) - scaled(samples_.nearest());
    if (range < 2 * step)
        return;
    Steps used{};
    find_steps(used);
    std::array<std::uint16_t, most_steps + 1> layer_of;
    int before = -2;
    for (std::size_t word = 0; word < used.size(); ++word)
        for (std::uint64_t left = used[word]; left != 0; left &= left - 1) {
            const int k = int(64 * word) + __builtin_ctzll(left);
            if (k > before + 1)
                layers_.emplace_back();
            layer_of[std::size_t(k)] = std::uint16_t(layers_.size() - 1);
            before = k;
        }
    if (layers_.size() > 1)
        for (Met& met : samples_.met())
            met.layer = layer_of[met.layer];
}

/// The light of a sample, times StoredLight::of_squared_root.
inline FourFloats light_of(const StoredLight& light)
{
    const FourFloats roots = floats_from(&light);
    return roots * magnitude(roots);
}

/// Sums up the light of the layers, and finds how they lie.
void SampleLayers::sum_layers()
{
    const BeamPatch::Axis &across = samples_.patch().axis(0), &along = samples_.patch().axis(1);
    for (const Met& met : samples_.met()) {
        Layer& layer = layers_[met.layer];
        const float depth = met.depth();
        layer.sums.add(met.weight(), met.numbers[1] * across.reach(depth),
                       met.numbers[2] * along.reach(depth), depth);
        layer.furthest = std::max(layer.furthest, depth);
        layer.light += met.weight() * light_of(met.light);
    }
    for (Layer& layer : layers_) {
        layer.weight = layer.sums.weight();
        layer.depth = layer.sums.mean_depth();
        layer.plane = layer.sums.plane({across.reach(layer.depth), along.reach(layer.depth)});
    }
}

/// The mean square of places in the patch over the beam, along one axis, at a depth.
inline float mean_square(const BeamPatch::Axis& axis, float depth)
{
    const float cell = axis.cell(depth), pixel = axis.pixel(depth), both = cell + std::fabs(pixel);
    return (cell * cell + pixel * pixel) / (3 * both * both);
}

/// The sums for the beam's mean light, of all samples that ended in it: of one layer.
template <class Floats> INTEGRAL_INLINE FitSums SampleLayers::fit_with() const
{
    SampleFit<Floats> fit;
    const float depth = 0.5f * (samples_.nearest() + samples_.furthest());
    const FourFloats of_one = {0, 0, mean_square(samples_.patch().axis(0), depth),
                               mean_square(samples_.patch().axis(1), depth)};
    const Floats squares = of_halves<Floats>(of_one, of_one), one = eight_of<Floats>(1);
    const auto all = samples_.met();
    for (const Met* met = all.begin(); met < all.end(); met += 2) {
        const Floats numbers = of_halves<Floats>(met[0].numbers, met[1].numbers),
                     place = shuffled_halves<1, 2, 1, 2>(numbers, numbers),
                     factor = shuffled_halves<4, 4, 1, 2>(numbers, one),
                     roots = floats_from<Floats>(&met[0].light, &met[1].light);
        fit.add(repeated<0>(numbers), place * factor - squares, roots * magnitude(roots));
    }
    return fit.sums();
}

#ifdef INTEGRAL_HAS_AVX2
INTEGRAL_TARGET_AVX2 FitSums SampleLayers::fit_with_avx2() const { return fit_with<EightFloats>(); }
#endif

/// The beam's mean light, of all samples that ended in it: of one layer.
FourFloats SampleLayers::fitted() const
{
#ifdef INTEGRAL_HAS_AVX2
    if (has_avx2())
        return fit_with_avx2().mean_of_beam();
#endif
    return fit_with<TwiceFourFloats>().mean_of_beam();
}

/// The samples that reach a layer's plane inside the beam. `before`: the furthest depth of the
/// layer before it.
template <class Floats>
INTEGRAL_INLINE ReachingSamples<float> SampleLayers::reaching_with(const Layer& layer,
                                                                   float before) const
{
    const Floats none = eight_of<Floats>(0);
    ReachingSamples<Floats> result;
    for (const WeighedSamples::Group& group : samples_.groups()) {
        const auto crossing = layer.plane.crossing<Floats>(group.lines);
        const auto at = samples_.density(group, crossing.depth);
        const Floats areas = loaded<Floats>(group.areas), depths = loaded<Floats>(group.depths),
                     share = chosen(crossing.towards > none, loaded<Floats>(group.shares), none),
                     weight = chosen(depths > eight_of<Floats>(before), share * at.value, none);
        if (!any(weight > none))
            continue;
        // Where the samples' surfaces, as planes, are met by lines of the pixel's direction that
        // cross the samples' lines at the layer. A line that would meet the other side of a surface
        // tells nothing of it; that the sample went as far as its own depth is known.
        const Floats seen_depths = crossing.depth +
                                   (depths - crossing.depth) /
                                       chosen(areas > none, areas, eight_of<Floats>(1)),
                     passed = chosen(seen_depths > eight_of<Floats>(layer.furthest), weight, none);
        result.add(weight, weight - passed, at.x, at.y);
        result.passing = result.passing +
                         (covers_.none() ? passed : passed * covers_.open(at.x, at.y));
    }
    return result.sums();
}

#ifdef INTEGRAL_HAS_AVX2
INTEGRAL_TARGET_AVX2
ReachingSamples<float> SampleLayers::reaching_with_avx2(const Layer& layer, float before) const
{
    return reaching_with<EightFloats>(layer, before);
}
#endif

ReachingSamples<float> SampleLayers::reaching(const Layer& layer, float before) const
{
#ifdef INTEGRAL_HAS_AVX2
    if (has_avx2())
        return reaching_with_avx2(layer, before);
#endif
    return reaching_with<TwiceFourFloats>(layer, before);
}

/// Reduces a layer's weight and light to what the layers before it let through.
void SampleLayers::see_through_covers(Layer& layer)
{
    const int number = int(&layer - layers_.data());
    covers_.look_from(samples_.patch(), layer.depth);
    float weight = 0;
    FourFloats light{};
    for (const Met& met : samples_.met())
        if (met.layer == number) {
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
    float open = 1, behind = samples_.weight(),
          before = -1e9f; // open: what the layers before let through
    for (Layer& layer : layers_) {
        behind -= layer.weight;
        const bool is_little = layer.weight < little_part * behind;
        float covered = is_little ? layer.weight / (layer.weight + behind) : 1;
        if (!covers_.none())
            see_through_covers(layer);
        if (!is_little && &layer != &layers_.back()) {
            const ReachingSamples<float> samples = reaching(layer, before);
            covered = layer.weight / (layer.weight + samples.passing);
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
    samples_.weigh();
    if (!(samples_.weight() > 0))
        return {};
    const BeamPatch::Axis& axis = samples_.patch().axis(0);
    steepness_ = axis.pixel_slope / axis.cell_at_sheet;
    covers_.clear();
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
    result.own_part = samples_.own_part();
    return result;
}

float SampleLayers::variance() const
{
    FourFloats sum{}, squares{};
    for (const Met& met : samples_.met()) {
        const FourFloats root = floats_from(&met.light), weighted = met.weight() * root;
        sum += weighted;
        squares += weighted * root;
    }
    const float weight = samples_.weight();
    const FourFloats mean = sum / weight,
                     variance = StoredLight::of_squared_root * (squares / weight - mean * mean);
    return std::max(0.0f, variance[0] + variance[1] + variance[2]);
}

} // namespace integral
