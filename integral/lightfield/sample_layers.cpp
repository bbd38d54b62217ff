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

/// Half the patch's width along both axes, beside two ones: 1, x, y, 1.
class HalfWidths {
public:
    explicit HalfWidths(const BeamPatch& patch)
    {
        for (int k = 0; k < 2; ++k) {
            const BeamPatch::Axis& axis = patch.axis(k);
            cell_at_sheet_[k + 1] = 0.5f * axis.cell_at_sheet;
            cell_slope_[k + 1] = 0.5f * axis.cell_slope;
            pixel_at_sheet_[k + 1] = 0.5f * axis.pixel_at_sheet;
            pixel_slope_[k + 1] = 0.5f * axis.pixel_slope;
        }
    }
    FourFloats operator()(float depth) const
    {
        return cell_at_sheet_ + std::fabs(depth) * cell_slope_ +
               magnitude(pixel_at_sheet_ + depth * pixel_slope_);
    }

private:
    FourFloats cell_at_sheet_{1, 0, 0, 1}, cell_slope_{}, pixel_at_sheet_{}, pixel_slope_{};
};

} // namespace

/// A depth on the scale on which layers are told apart.
template <class Floats> INTEGRAL_INLINE Floats SampleLayers::scaled(Floats depth) const
{
    const Floats one = eight_of<Floats>(1), none = eight_of<Floats>(0),
                 value = eight_of<Floats>(2.2f) *
                         logarithm(one + magnitude(depth) * eight_of<Floats>(steepness_));
    return chosen(depth < none, none - value, value);
}

/// Sets each sample's step on the scale, counted from the nearest one's, and adds it to `steps`.
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
            met[i].step = std::uint16_t(int(found[i]));
            steps[met[i].step / 64] |= std::uint64_t(1) << met[i].step % 64;
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
        order_by_layer(layer_of.data());
}

/// Lists the samples layer by layer. `layer_of`: the layer of each step.
void SampleLayers::order_by_layer(const std::uint16_t* layer_of)
{
    const auto all = samples_.met();
    for (const Met& met : all)
        ++layers_[layer_of[met.step]].end;
    std::uint32_t begin = 0;
    for (Layer& layer : layers_) {
        const std::uint32_t number = layer.end;
        layer.begin = layer.end = begin;
        begin += number;
    }
    if (ordered_.size() < begin)
        ordered_.resize(2 * begin);
    for (const Met& met : all)
        ordered_[layers_[layer_of[met.step]].end++] = &met;
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
    const HalfWidths half_widths(samples_.patch());
    for (Layer& layer : layers_) {
        LayerPlane::Sums sums;
        FourFloats light{};
        float furthest = -1e9f;
        for (std::uint32_t k = layer.begin; k < layer.end; ++k) {
            const Met& met = *ordered_[k];
            FourFloats place = met.numbers;
            place[0] = 1;
            sums.add(met.weight(), place * half_widths(met.depth()));
            light += met.weight() * light_of(met.light);
            furthest = std::max(furthest, met.depth());
        }
        layer.weight = sums.weight();
        layer.depth = sums.mean_depth();
        layer.furthest = furthest;
        layer.light = light;
        const FourFloats reach = half_widths(layer.depth);
        layer.plane = sums.plane({reach[1], reach[2]});
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
    covers_.look_from(samples_.patch(), layer.depth);
    float weight = 0;
    FourFloats light{};
    for (std::uint32_t k = layer.begin; k < layer.end; ++k) {
        const Met& met = *ordered_[k];
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
