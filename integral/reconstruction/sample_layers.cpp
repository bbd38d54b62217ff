// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/reconstruction/sample_layers.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "integral/base/vector_loops.h"

namespace integral {

namespace {

// Depths are compared on a scale along which the rays of neighbouring pixels diverge by about a
// footprint's width per unit. The scale is divided into steps of this size; adjacent layers are
// separated by at least one empty step.
constexpr float step = 0.08f;

// A beam widens with its distance from the sheet. Where it is wider by more than widened_by lens
// widths, the samples of a floor that is seen nearly edge-on are few and at many depths. Such a
// floor and the sky behind it are treated as one layer, because one fit weights their samples
// better than layers that hide each other. If the pixel also sees something nearer, only those
// layers are joined that are so far away that the beam is wider by widened_behind_by lens widths.
constexpr float widened_by = 0.5f, widened_behind_by = 2;

// A layer whose weight is less than little_part of the weight of all layers behind it ("little") is
// neither fitted nor added to covers_. What lies behind layers that together let through less than
// little_light is left out.
constexpr float little_part = 0.06f, little_light = 0.01f;

// Layers with a larger tilt (LayerPlane::tilt) are not fitted to places: where a floor ends at its
// horizon, many of a beam's rays never come down to the floor, and the other rays are unevenly
// distributed on it.
constexpr float most_tilt = 0.25f;

/// Approximate logarithm of x to base 2, for x >= 1: linear between powers of two.
template <class Floats> INTEGRAL_INLINE Floats logarithm(Floats x)
{
    return bits_as_number(x) * broadcast<Floats>(0x1p-23f) - broadcast<Floats>(127);
}

} // namespace

/// A depth on the scale on which layers are separated.
template <class Floats> INTEGRAL_INLINE Floats SampleLayers::scaled(Floats depth) const
{
    const Floats one = broadcast<Floats>(1), none = broadcast<Floats>(0),
                 value = broadcast<Floats>(2.2f) *
                         logarithm(one + abs(depth) * broadcast<Floats>(divergence_));
    return select(depth < none, none - value, value);
}

/// Sets each sample's step on the scale, counted from the nearest sample's, and adds it to `steps`.
template <class Floats> INTEGRAL_INLINE void SampleLayers::find_steps(Steps& steps)
{
    const Floats begin = broadcast<Floats>(scaled(samples_.nearest())),
                 last = broadcast<Floats>(most_steps), of_step = broadcast<Floats>(1 / step);
    const WeightedSamples::HitSamples& hits = samples_.hits();
    for (std::size_t eight = 0; eight < hits.eights(); ++eight) {
        Eight& found = placed_[eight].steps;
        store(found, min((scaled(hits.depths<Floats>(eight)) - begin) * of_step, last));
        const std::size_t number = std::min<std::size_t>(8, hits.number() - 8 * eight);
        for (std::size_t i = 0; i < number; ++i) {
            const unsigned k = unsigned(int(found[i]));
            steps[k / 64] |= std::uint64_t(1) << k % 64;
        }
    }
}

/// Divides the samples that ended in the beam into layers, beginning at the viewer.
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

/// Joins the layers far behind the sheet into one, if they are more than two: such layers are
/// mostly pieces of a floor, and the sky.
inline void SampleLayers::join_far_layers()
{
    const float widening = samples_.patch().widening();
    if (!(widening > 0))
        return;
    const float first = (scaled(widened_behind_by / widening) - scaled(samples_.nearest())) / step;
    const auto far = std::find_if(layers_.begin(), layers_.end(),
                                  [&](const Layer& layer) { return layer.first_step >= first; });
    if (layers_.end() - far <= 2)
        return;
    far->end_step = layers_.back().end_step;
    layers_.erase(far + 1, layers_.end());
}

/// The weights of eight samples, or 0 for samples outside `layer` (null: none are outside).
template <class Floats>
INTEGRAL_INLINE Floats SampleLayers::weights_in(const Layer* layer, std::size_t eight) const
{
    if (!layer)
        return samples_.hits().weights<Floats>(eight);
    const Floats steps = load<Floats>(placed_[eight].steps), none = broadcast<Floats>(0),
                 begun = select(steps < broadcast<Floats>(layer->first_step), none,
                                samples_.hits().weights<Floats>(eight));
    return select(steps < broadcast<Floats>(layer->end_step), begun, none);
}

/// Computes the layers' weights, depths and planes.
template <class Floats> INTEGRAL_INLINE void SampleLayers::place_layers()
{
    const WeightedSamples::HitSamples& hits = samples_.hits();
    const BeamFootprint& patch = samples_.patch();
    for (std::size_t eight = 0; eight < hits.eights(); ++eight)
        for (int axis = 0; axis < 2; ++axis)
            store(placed_[eight].ways[axis],
                  hits.places<Floats>(axis, eight) *
                      patch.axis(axis).reach(hits.depths<Floats>(eight)));
    for (Layer& layer : layers_) {
        LinearSums<Floats> sums;
        Floats furthest = broadcast<Floats>(-1e9f);
        for (std::size_t eight = 0; eight < hits.eights(); ++eight) {
            const Floats weights = weights_in<Floats>(&layer, eight),
                         depths = hits.depths<Floats>(eight);
            sums.add(weights, weights * depths, load<Floats>(placed_[eight].ways[0]),
                     load<Floats>(placed_[eight].ways[1]));
            furthest = max(furthest, select(weights > broadcast<Floats>(0), depths, furthest));
        }
        const LinearSums<float> all = sums.sums();
        Eight all_furthest;
        store(all_furthest, furthest);
        layer.furthest = *std::max_element(all_furthest.values, all_furthest.values + 8);
        layer.weight = all.weight;
        layer.depth = all.value / all.weight;
        layer.plane = LayerPlane(
            all, {patch.axis(0).reach(layer.depth), patch.axis(1).reach(layer.depth)},
            patch.furthest_depth());
    }
}

/// Computes Placed::squares, for regressions, of all samples that ended in the beam: with the
/// footprint at the depth of `layer`, or, if that is null, at each sample's own depth.
template <class Floats> INTEGRAL_INLINE void SampleLayers::find_squares(const Layer* layer)
{
    const WeightedSamples::HitSamples& hits = samples_.hits();
    for (std::size_t eight = 0; eight < hits.eights(); ++eight) {
        const Floats depths = layer ? broadcast<Floats>(layer->depth) : hits.depths<Floats>(eight);
        for (int axis = 0; axis < 2; ++axis)
            store(placed_[eight].squares[axis], samples_.patch().axis(axis).square_above_mean(
                                                    hits.places<Floats>(axis, eight), depths));
    }
}

/// The regressors of eight samples: their places x, y and the squares (find_squares).
template <class Floats>
INTEGRAL_INLINE void SampleLayers::fitted_places(std::size_t eight, Floats (&places)[4]) const
{
    for (int axis = 0; axis < 2; ++axis) {
        places[axis] = samples_.hits().places<Floats>(axis, eight);
        places[2 + axis] = load<Floats>(placed_[eight].squares[axis]);
    }
}

/// Sums over the places of a layer's samples (null: of all samples that ended in the beam).
template <class Floats>
INTEGRAL_INLINE PlaceSums<Floats> SampleLayers::places_of(const Layer* layer) const
{
    const WeightedSamples::HitSamples& hits = samples_.hits();
    PlaceSums<Floats> sums;
    for (std::size_t eight = 0; eight < hits.eights(); ++eight) {
        Floats places[4];
        fitted_places(eight, places);
        sums.add(weights_in<Floats>(layer, eight), places);
    }
    return sums;
}

/// The same sums over the samples' light. In two loops, so that the processor has enough registers
/// for each of them.
template <class Floats> INTEGRAL_INLINE ValueSums SampleLayers::light_of(const Layer* layer) const
{
    const WeightedSamples::HitSamples& hits = samples_.hits();
    LightPairSums<Floats> sums[2];
    for (int pair = 0; pair < 2; ++pair)
        for (std::size_t eight = 0; eight < hits.eights(); ++eight) {
            Floats places[4], light[2];
            fitted_places(eight, places);
            hits.light_pair(pair, eight, light);
            sums[pair].add(weights_in<Floats>(layer, eight), places, light);
        }
    return ValueSums(sums);
}

/// The smallest light of a layer's samples, component by component.
template <class Floats>
INTEGRAL_INLINE FourFloats SampleLayers::least_light(const Layer* layer) const
{
    const WeightedSamples::HitSamples& hits = samples_.hits();
    const Floats none = broadcast<Floats>(0);
    FourFloats least_of_all{};
    for (int component = 0; component < 4; ++component) {
        Floats all = broadcast<Floats>(1e9f);
        for (std::size_t eight = 0; eight < hits.eights(); ++eight) {
            Floats light[2];
            hits.light_pair(component / 2, eight, light);
            all = select(weights_in<Floats>(layer, eight) > none, min(all, light[component % 2]),
                         all);
        }
        Eight each;
        store(each, all);
        least_of_all[component] = *std::min_element(each.values, each.values + 8);
    }
    return least_of_all;
}

/// Light of a layer by regression. Near bright spots a fit may be too dark: if it is below half the
/// samples' mean in any component, the light is raised to at least the smallest light of the
/// layer's samples, times `covered`, the fraction of the beam that the layer covers.
template <class Floats>
INTEGRAL_INLINE FourFloats SampleLayers::fitted_light(const PlaceRegression& regression,
                                                      const Layer* layer, float covered) const
{
    const ValueSums sums = light_of<Floats>(layer);
    const FourFloats light = regression.mean_over_beam(sums) / std::max(1.0f, covered);
    if (!any(light < 0.5f * regression.mean(sums)))
        return light;
    return max(light, std::clamp(covered, 0.0f, 1.0f) * least_light<Floats>(layer));
}

/// The mean light of a beam with one layer, from all samples that ended in it.
template <class Floats> INTEGRAL_INLINE FourFloats SampleLayers::only_layer()
{
    find_squares<Floats>(nullptr);
    return fitted_light<Floats>(PlaceRegression(places_of<Floats>(nullptr)), nullptr, 1);
}

/// Sums over the samples that reach a layer's plane inside the beam. `before`: the furthest depth
/// of the layer before it. The places of the samples that go on are added to `places`, if it is not
/// null.
template <class Floats>
INTEGRAL_INLINE ReachingSamples<float> SampleLayers::reaching(const Layer& layer, float before,
                                                              PlaceSums<Floats>* places) const
{
    const BeamFootprint& patch = samples_.patch();
    const Floats none = broadcast<Floats>(0), layer_depth = broadcast<Floats>(layer.depth);
    ReachingSamples<Floats> result;
    for (const WeightedSamples::Group& group : samples_.groups()) {
        const auto crossing = layer.plane.crossing<Floats>(group.lines);
        const auto at = samples_.density(group, crossing.depth);
        const Floats areas = load<Floats>(group.areas), depths = load<Floats>(group.depths),
                     share = select(crossing.towards > none, load<Floats>(group.shares), none),
                     weight = select(depths > broadcast<Floats>(before), share * at.value, none);
        if (!any(weight > none))
            continue;
        // seen_depths: where the plane of a sample's surface is met by the ray of the pixel's
        // direction that crosses the sample's ray at the layer; or, if that ray would meet the
        // surface's other side, the sample's depth, which the sample is known to have reached.
        const Floats seen_depths = crossing.depth +
                                   (depths - crossing.depth) /
                                       select(areas > none, areas, broadcast<Floats>(1)),
                     passed = select(seen_depths > broadcast<Floats>(layer.furthest), weight, none);
        result.ended.add(weight, weight - passed, at.x, at.y);
        result.passing = result.passing +
                         (covers_.none() ? passed : passed * covers_.transmittance(at.x, at.y));
        if (places) {
            const Floats numbers[4] = {at.x, at.y,
                                       patch.axis(0).square_above_mean(at.x, layer_depth),
                                       patch.axis(1).square_above_mean(at.y, layer_depth)};
            places->add(passed, numbers);
        }
    }
    return result.sums();
}

/// The light and the weight of a layer's samples, as seen through the layers before it.
template <class Floats>
INTEGRAL_INLINE SampleLayers::Shown SampleLayers::seen_through_covers(const Layer& layer)
{
    covers_.look_from(samples_.patch(), layer.depth);
    const WeightedSamples::HitSamples& hits = samples_.hits();
    Floats weight = broadcast<Floats>(0);
    LightSums<Floats> light;
    for (std::size_t eight = 0; eight < hits.eights(); ++eight) {
        const Floats seen = weights_in<Floats>(&layer, eight) *
                            covers_.transmittance(hits.places<Floats>(0, eight),
                                                  hits.places<Floats>(1, eight));
        weight = weight + seen;
        light.add(seen, hits, eight);
    }
    return {light.sums(), sum_of_eight(weight)};
}

/// Part of a layer that nothing hides, by regressions over the samples that reach the layer;
/// samples that go on count as dark. Adds the layer to `covers_`.
template <class Floats>
INTEGRAL_INLINE SampleLayers::Part SampleLayers::fitted_part(const Layer& layer, float before)
{
    find_squares<Floats>(&layer);
    const PlaceSums<Floats> ended = places_of<Floats>(&layer);
    PlaceSums<Floats> all = ended;
    covers_.add(layer.depth, reaching<Floats>(layer, before, &all));
    const PlaceRegression regression(all);
    ValueSums cover; // of a value that is 1 for samples that end at the layer, else 0
    cover.values[0] = sum_of_eight(ended.weight);
    for (int k = 0; k < 4; ++k)
        cover.by_place[k][0] = sum_of_eight(ended.places[k]);
    const float covered = regression.mean_over_beam(cover)[0];
    return {fitted_light<Floats>(regression, &layer, covered), std::clamp(covered, 0.0f, 1.0f)};
}

/// A layer's part by means over its samples, as seen through the layers before it. Adds the layer
/// to `covers_`, unless it is the last one or little. `behind`: the weight of the layers after it.
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
          before = -1e9f; // open: fraction of the light that the layers before let through
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

/// Whether most samples, apart from the furthest, met a floor that is seen nearly edge-on.
bool SampleLayers::is_floor() const
{
    const float last = samples_.furthest() - 0.01f * std::fabs(samples_.furthest());
    return samples_.part_askew(last, samples_.patch().half_slopes(), most_tilt) > 0.5f;
}

/// The pixel's light; some samples must have met the beam.
template <class Floats> INTEGRAL_INLINE FourFloats SampleLayers::light_with()
{
    if (placed_.size() < samples_.hits().eights())
        placed_.resize(2 * samples_.hits().eights());
    find_layers<Floats>();
    if (layers_.size() < 2)
        return only_layer<Floats>();
    const float nearest = std::max(samples_.nearest(), -samples_.furthest()); // < 0: on both sides
    const bool is_far = nearest * samples_.patch().widening() > widened_by;
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
    divergence_ = samples_.patch().divergence();
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
