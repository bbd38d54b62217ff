// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/sample_layers.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "integral/base/vector_loops.h"

namespace integral {

namespace {

// Depths are compared on a scale on which the lines of neighbouring pixels move apart by about a
// patch's width from one number to the next. Two layers have an empty step between them.
constexpr float step = 0.08f;

// Where a pixel widens its beam by more than this part of a lens's width, a floor that is seen
// nearly edge-on has few samples at many depths. These and those of the sky behind it are taken for
// one layer: a fit tells better how much each of them counts than layers that hide each other. If
// the pixel sees something nearer, too, layers are joined only where it widens its beam by
// widened_behind_by lenses' widths.
constexpr float widened_by = 0.5f, widened_behind_by = 2;

// A layer of less than this part of what is behind it is not looked at closely, and what is behind
// layers that let less than this through is left out.
constexpr float little_part = 0.06f, little_light = 0.01f;

// Layers that are more tilted (LayerPlane::tilt) are not fitted to places: where a floor ends at
// its horizon, many of a beam's lines never come down to it, and the others do not lie evenly on
// it.
constexpr float most_tilt = 0.25f;

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

/// Sets each sample's step on the scale, counted from the nearest one's, and adds it to `steps`.
template <class Floats> INTEGRAL_INLINE void SampleLayers::find_steps(Steps& steps)
{
    const Floats begin = eight_of<Floats>(scaled(samples_.nearest())),
                 last = eight_of<Floats>(most_steps), of_step = eight_of<Floats>(1 / step);
    const WeighedSamples::Met& met = samples_.met();
    for (std::size_t eight = 0; eight < met.eights(); ++eight) {
        Eight& found = placed_[eight].steps;
        store(found, least((scaled(met.depths<Floats>(eight)) - begin) * of_step, last));
        const std::size_t number = std::min<std::size_t>(8, met.number() - 8 * eight);
        for (std::size_t i = 0; i < number; ++i) {
            const unsigned k = unsigned(int(found[i]));
            steps[k / 64] |= std::uint64_t(1) << k % 64;
        }
    }
}

/// Divides the samples that ended in the beam into layers, from the viewer on.
template <class Floats> INTEGRAL_INLINE void SampleLayers::find_layers()
{
    layers_.clear();
    const float range = scaled(samples_.furthest()) - scaled(samples_.nearest());
    if (range < 2 * step)
        return;
    Steps used{};
    find_steps<Floats>(used);
    int before = -2;
    for (std::size_t word = 0; word < used.size(); ++word)
        for (std::uint64_t left = used[word]; left != 0; left &= left - 1) {
            const int k = int(64 * word) + __builtin_ctzll(left);
            if (k > before + 1) {
                layers_.emplace_back();
                layers_.back().first_step = float(k);
            }
            layers_.back().end_step = float(k + 1);
            before = k;
        }
}

/// Makes one layer of those that are far behind the sheet, if they are more than two: mostly pieces
/// of a floor, and the sky.
inline void SampleLayers::join_far_layers()
{
    const float first = (scaled(widened_behind_by / steepness_) - scaled(samples_.nearest())) /
                        step;
    const auto far = std::find_if(layers_.begin(), layers_.end(),
                                  [&](const Layer& layer) { return layer.first_step >= first; });
    if (layers_.end() - far <= 2)
        return;
    far->end_step = layers_.back().end_step;
    layers_.erase(far + 1, layers_.end());
}

/// The weights of eight samples as far as they are in a layer, or in any (null); those of others
/// are 0.
template <class Floats>
INTEGRAL_INLINE Floats SampleLayers::weights_in(const Layer* layer, std::size_t eight) const
{
    if (!layer)
        return samples_.met().weights<Floats>(eight);
    const Floats steps = loaded<Floats>(placed_[eight].steps), none = eight_of<Floats>(0),
                 begun = chosen(steps < eight_of<Floats>(layer->first_step), none,
                                samples_.met().weights<Floats>(eight));
    return chosen(steps < eight_of<Floats>(layer->end_step), begun, none);
}

/// Finds the layers' weights, and how they lie.
template <class Floats> INTEGRAL_INLINE void SampleLayers::place_layers()
{
    const WeighedSamples::Met& met = samples_.met();
    const BeamPatch& patch = samples_.patch();
    for (std::size_t eight = 0; eight < met.eights(); ++eight)
        for (int axis = 0; axis < 2; ++axis)
            store(placed_[eight].ways[axis], met.places<Floats>(axis, eight) *
                                                 patch.axis(axis).reach(met.depths<Floats>(eight)));
    for (Layer& layer : layers_) {
        LinearSums<Floats> sums;
        Floats furthest = eight_of<Floats>(-1e9f);
        for (std::size_t eight = 0; eight < met.eights(); ++eight) {
            const Floats weights = weights_in<Floats>(&layer, eight),
                         depths = met.depths<Floats>(eight);
            sums.add(weights, weights * depths, loaded<Floats>(placed_[eight].ways[0]),
                     loaded<Floats>(placed_[eight].ways[1]));
            furthest = most(furthest, chosen(weights > eight_of<Floats>(0), depths, furthest));
        }
        const LinearSums<float> all = sums.sums();
        Eight all_furthest;
        store(all_furthest, furthest);
        layer.furthest = *std::max_element(all_furthest.values, all_furthest.values + 8);
        layer.weight = all.weight;
        layer.depth = all.value / all.weight;
        layer.plane = LayerPlane(
            all, {patch.axis(0).reach(layer.depth), patch.axis(1).reach(layer.depth)});
    }
}

/// Finds the squares that regressions are about, of all samples that ended in the beam: at the
/// depth of `layer`, or each at its own (null).
template <class Floats> INTEGRAL_INLINE void SampleLayers::find_squares(const Layer* layer)
{
    const WeighedSamples::Met& met = samples_.met();
    for (std::size_t eight = 0; eight < met.eights(); ++eight) {
        const Floats depths = layer ? eight_of<Floats>(layer->depth) : met.depths<Floats>(eight);
        for (int axis = 0; axis < 2; ++axis)
            store(placed_[eight].squares[axis], samples_.patch().axis(axis).square_above_mean(
                                                    met.places<Floats>(axis, eight), depths));
    }
}

/// The numbers of the places of eight samples that a regression is about: x, y and their squares.
template <class Floats>
INTEGRAL_INLINE void SampleLayers::fitted_places(std::size_t eight, Floats (&places)[4]) const
{
    for (int axis = 0; axis < 2; ++axis) {
        places[axis] = samples_.met().places<Floats>(axis, eight);
        places[2 + axis] = loaded<Floats>(placed_[eight].squares[axis]);
    }
}

/// Sums over the places of a layer's samples; `layer`: null: of all samples that ended in the beam.
template <class Floats>
INTEGRAL_INLINE PlaceSums<Floats> SampleLayers::places_of(const Layer* layer) const
{
    const WeighedSamples::Met& met = samples_.met();
    PlaceSums<Floats> sums;
    for (std::size_t eight = 0; eight < met.eights(); ++eight) {
        Floats places[4];
        fitted_places(eight, places);
        sums.add(weights_in<Floats>(layer, eight), places);
    }
    return sums;
}

/// The same sums over their light. In two loops: for each the processor has enough registers.
template <class Floats> INTEGRAL_INLINE ValueSums SampleLayers::light_of(const Layer* layer) const
{
    const WeighedSamples::Met& met = samples_.met();
    LightPairSums<Floats> sums[2];
    for (int pair = 0; pair < 2; ++pair)
        for (std::size_t eight = 0; eight < met.eights(); ++eight) {
            Floats places[4], light[2];
            fitted_places(eight, places);
            met.light_pair(pair, eight, light);
            sums[pair].add(weights_in<Floats>(layer, eight), places, light);
        }
    return ValueSums(sums);
}

/// The least light of a layer's samples, component by component.
template <class Floats>
INTEGRAL_INLINE FourFloats SampleLayers::least_light(const Layer* layer) const
{
    const WeighedSamples::Met& met = samples_.met();
    const Floats none = eight_of<Floats>(0);
    FourFloats least_of_all{};
    for (int component = 0; component < 4; ++component) {
        Floats all = eight_of<Floats>(1e9f);
        for (std::size_t eight = 0; eight < met.eights(); ++eight) {
            Floats light[2];
            met.light_pair(component / 2, eight, light);
            all = chosen(weights_in<Floats>(layer, eight) > none, least(all, light[component % 2]),
                         all);
        }
        Eight each;
        store(each, all);
        least_of_all[component] = *std::min_element(each.values, each.values + 8);
    }
    return least_of_all;
}

/// The light that a regression finds for a layer, which covers a part of the beam: not less than
/// that part of the least light of its samples. Beside bright spots a fit may pass below it.
template <class Floats>
INTEGRAL_INLINE FourFloats SampleLayers::fitted_light(const PlaceRegression& regression,
                                                      const Layer* layer, float covered) const
{
    const ValueSums sums = light_of<Floats>(layer);
    const FourFloats light = regression.mean_over_beam(sums) / std::max(1.0f, covered);
    if (!any(light < 0.5f * regression.mean(sums)))
        return light;
    return most(light, std::clamp(covered, 0.0f, 1.0f) * least_light<Floats>(layer));
}

/// The beam's mean light, of all samples that ended in it: of one layer.
template <class Floats> INTEGRAL_INLINE FourFloats SampleLayers::only_layer()
{
    find_squares<Floats>(nullptr);
    return fitted_light<Floats>(PlaceRegression(places_of<Floats>(nullptr)), nullptr, 1);
}

/// The samples that reach a layer's plane inside the beam. `before`: the furthest depth of the
/// layer before it. The places of those that go on are added to `places`, if it is not null.
template <class Floats>
INTEGRAL_INLINE ReachingSamples<float> SampleLayers::reaching(const Layer& layer, float before,
                                                              PlaceSums<Floats>* places) const
{
    const BeamPatch& patch = samples_.patch();
    const Floats none = eight_of<Floats>(0), layer_depth = eight_of<Floats>(layer.depth);
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
        result.ended.add(weight, weight - passed, at.x, at.y);
        result.passing = result.passing +
                         (covers_.none() ? passed : passed * covers_.open(at.x, at.y));
        if (places) {
            const Floats numbers[4] = {at.x, at.y,
                                       patch.axis(0).square_above_mean(at.x, layer_depth),
                                       patch.axis(1).square_above_mean(at.y, layer_depth)};
            places->add(passed, numbers);
        }
    }
    return result.sums();
}

/// The light and the weight of a layer's samples, as far as they are seen through the layers before
/// it.
template <class Floats>
INTEGRAL_INLINE SampleLayers::Shown SampleLayers::seen_through_covers(const Layer& layer)
{
    covers_.look_from(samples_.patch(), layer.depth);
    const WeighedSamples::Met& met = samples_.met();
    Floats weight = eight_of<Floats>(0);
    LightSums<Floats> light;
    for (std::size_t eight = 0; eight < met.eights(); ++eight) {
        const Floats seen = weights_in<Floats>(&layer, eight) *
                            covers_.open(met.places<Floats>(0, eight),
                                         met.places<Floats>(1, eight));
        weight = weight + seen;
        light.add(seen, met, eight);
    }
    return {light.sums(), sum_of_eight(weight)};
}

/// A layer's part by regressions over the samples that reach it, in which those that go on count as
/// dark; for a layer that nothing hides. Adds it to the covers.
template <class Floats>
INTEGRAL_INLINE SampleLayers::Part SampleLayers::fitted_part(const Layer& layer, float before)
{
    find_squares<Floats>(&layer);
    const PlaceSums<Floats> ended = places_of<Floats>(&layer);
    PlaceSums<Floats> all = ended;
    covers_.add(layer.depth, reaching<Floats>(layer, before, &all));
    const PlaceRegression regression(all);
    ValueSums cover; // of a value that is 1 where a sample ends
    cover.values[0] = sum_of_eight(ended.weight);
    for (int k = 0; k < 4; ++k)
        cover.by_place[k][0] = sum_of_eight(ended.places[k]);
    const float covered = regression.mean_over_beam(cover)[0];
    return {fitted_light<Floats>(regression, &layer, covered), std::clamp(covered, 0.0f, 1.0f)};
}

/// A layer's part by means over its samples, as far as they are seen through the layers before it.
/// Adds it to the covers, unless it is the last or little. `behind`: the weight of the layers after
/// it.
template <class Floats>
INTEGRAL_INLINE SampleLayers::Part SampleLayers::plain_part(const Layer& layer, float before,
                                                            float behind, bool is_little)
{
    float covered = is_little ? layer.weight / (layer.weight + behind) : 1;
    const Shown shown = seen_through_covers<Floats>(layer);
    if (!is_little && &layer != &layers_.back()) {
        const ReachingSamples<float> samples = reaching<Floats>(layer, before, nullptr);
        covered = shown.weight / (shown.weight + samples.passing);
        covers_.add(layer.depth, samples);
    }
    return {covered / shown.weight * shown.light, covered};
}

/// The light of all layers, each seen through those before it.
template <class Floats> INTEGRAL_INLINE FourFloats SampleLayers::composed()
{
    FourFloats sum{};
    float open = 1, behind = samples_.weight(),
          before = -1e9f; // open: what the layers before let through
    for (const Layer& layer : layers_) {
        behind -= layer.weight;
        const bool is_little = layer.weight < little_part * behind,
                   is_fitted = covers_.none() && !is_little && &layer != &layers_.back() &&
                               layer.plane.tilt(samples_.patch().half_slopes()) < most_tilt;
        const Part part = is_fitted ? fitted_part<Floats>(layer, before)
                                    : plain_part<Floats>(layer, before, behind, is_little);
        sum += open * part.light;
        open *= 1 - part.covered;
        before = layer.furthest;
        if (open < little_light)
            break;
    }
    return sum;
}

/// Whether most of what was met, but for the furthest, is a floor that is seen nearly edge-on.
bool SampleLayers::is_floor() const
{
    const float last = samples_.furthest() - 0.01f * std::fabs(samples_.furthest());
    return samples_.part_askew(last, samples_.patch().half_slopes(), most_tilt) > 0.5f;
}

/// The pixel's light; some samples must have met the beam.
template <class Floats> INTEGRAL_INLINE FourFloats SampleLayers::light_with()
{
    if (placed_.size() < samples_.met().eights())
        placed_.resize(2 * samples_.met().eights());
    find_layers<Floats>();
    if (layers_.size() < 2)
        return only_layer<Floats>();
    const float nearest = std::max(samples_.nearest(), -samples_.furthest()); // < 0: on both sides
    const bool is_far = nearest * steepness_ > widened_by;
    if (is_far && is_floor())
        return only_layer<Floats>();
    if (!is_far)
        join_far_layers();
    place_layers<Floats>();
    return composed<Floats>();
}

#ifdef INTEGRAL_HAS_AVX2
INTEGRAL_TARGET_AVX2 FourFloats SampleLayers::light_with_avx2()
{
    return light_with<EightFloats>();
}
#endif

std::optional<SampleLayers::Light> SampleLayers::light()
{
    samples_.weigh();
    if (!(samples_.weight() > 0))
        return {};
    const BeamPatch::Axis& axis = samples_.patch().axis(0);
    steepness_ = axis.pixel_slope / axis.cell_at_sheet;
    covers_.clear();
    FourFloats light;
#ifdef INTEGRAL_HAS_AVX2
    if (has_avx2())
        light = light_with_avx2();
    else
#endif
        light = light_with<TwiceFourFloats>();
    light *= StoredLight::of_squared_root;
    Light result;
    std::memcpy(&result.light, &light, sizeof light);
    result.own_part = samples_.own_part();
    return result;
}

} // namespace integral
