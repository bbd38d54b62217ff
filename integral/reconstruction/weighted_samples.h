// SPDX-License-Identifier: AGPL-3.0-or-later
// Weights the samples of many pixels for one pixel: by the density of its beam at the place that
// each sample met, and by the surface's tilt to the beam.
//
// A frame has hundreds of such samples for each of its pixels, so that reconstruction spends most
// of its time here. Eight samples are processed side by side.
#ifndef INTEGRAL_RECONSTRUCTION_WEIGHTED_SAMPLES_H
#define INTEGRAL_RECONSTRUCTION_WEIGHTED_SAMPLES_H

#include "integral/base/eight_floats.h"
#include "integral/reconstruction/beam_footprint.h"

#include <vector>

namespace integral {

class WeightedSamples {
public:
    // The density of a beam falls to 0 over the narrower of its two widths plus this fraction of
    // their sum, so that a width of 0 causes no division by 0.
    static constexpr float least_fall = 1e-4f;

    /// The elements of an array, for range-based loops.
    template <class Element> struct Range {
        Element *first, *last;
        Element* begin() const { return first; }
        Element* end() const { return last; }
    };

    /// Begins a pixel. `centre`: the central ray of its beam. `samples`: the store of the samples
    /// that will be added; it must outlive weigh().
    void begin(const BeamFootprint& patch, const LightFieldRay& centre, const BeamSamples& samples);

    /// Adds the pixel's own samples. Must be called before add().
    void add_own(const BeamSamples::Pixel& pixel)
    {
        add(&pixel, 1, {{1}});
        own_number_ = number_;
    }
    /// Adds the samples of the pixels pixels[k] for which bit k of `which` is set (k < 8); these
    /// pixels must not be empty. `parts`: their weights, 0 to 1.
    void add(const BeamSamples::Pixel* pixels, unsigned which, const Eight& parts);

    /// Computes the weights of all samples that were added, and lists the samples with a weight
    /// above 0 (hits()).
    void weigh();

    /// Eight samples side by side; the last group of a pixel is padded with samples whose share is
    /// 0.
    struct Group {
        /// Their rays minus the central ray: point x, y (mm), slope x, y.
        Eight lines[4];
        Eight depths;  ///< mm
        Eight areas;   ///< projected areas of the samples' surfaces in the pixel's direction,
                       ///< divided by those in the samples' directions; below 0: the pixel would
                       ///< see the other side
        Eight shares;  ///< the samples' weights before density and tilt
        Eight weights; ///< the shares times the beam's density where the samples ended, times
                       ///< seen_part()
    };
    Range<const Group> groups() const { return {groups_.data(), groups_.data() + group_number_}; }

    /// The samples that ended in the beam. They are read eight at a time; the last eight are padded
    /// with samples whose weight is 0.
    class HitSamples {
    public:
        std::size_t number() const { return number_; }
        std::size_t eights() const { return (number_ + 7) / 8; }

        /// Loads eight consecutive samples (structure of arrays).
        template <class Floats> INTEGRAL_INLINE Floats weights(std::size_t eight) const
        {
            return column<Floats>(of_weights, eight);
        }
        /// The places in the footprint, -1 to 1, along both axes (0 and 1).
        template <class Floats> INTEGRAL_INLINE Floats places(int axis, std::size_t eight) const
        {
            return column<Floats>(axis == 0 ? of_x : of_y, eight);
        }
        /// The depths, mm.
        template <class Floats> INTEGRAL_INLINE Floats depths(std::size_t eight) const
        {
            return column<Floats>(of_depths, eight);
        }
        /// The stored square roots of red and green (pair 0), or of blue and transparency (1).
        template <class Floats>
        INTEGRAL_INLINE void root_pair(int pair, std::size_t eight, Floats (&roots)[2]) const
        {
            split_pairs(column<Floats>(pair == 0 ? of_red_and_green : of_blue_and_more, eight),
                        roots[0], roots[1]);
        }
        /// The light of the same pair, divided by StoredLight::of_squared_root.
        template <class Floats>
        INTEGRAL_INLINE void light_pair(int pair, std::size_t eight, Floats (&light)[2]) const
        {
            root_pair(pair, eight, light);
            for (Floats& root : light)
                root = root * abs(root);
        }

    private:
        friend class WeightedSamples;
        enum Column { of_weights, of_x, of_y, of_depths, of_red_and_green, of_blue_and_more, all };
        template <class Floats> INTEGRAL_INLINE Floats column(Column which, std::size_t eight) const
        {
            return load<Floats>(columns_[which].data() + 8 * eight);
        }
        std::array<std::vector<float>, all> columns_;
        std::size_t number_ = 0;
    };
    const HitSamples& hits() const { return met_; }

    /// The sum of the weights of the samples that ended in the beam, the fraction of it that
    /// belongs to the pixel's own samples, and the samples' smallest and greatest depth, mm.
    float weight() const { return weight_; }
    float own_part() const;
    float nearest() const { return nearest_; }
    float furthest() const { return furthest_; }

    /// The variance of the square roots of the light of the samples that ended in the beam, summed
    /// over red, green and blue. There must be such samples.
    float variance() const;

    /// Weight fraction of samples on tilted surfaces, among the samples that ended in the beam
    /// nearer than a depth (mm). A surface is tilted if its projected area changes by the fraction
    /// `change` or more along a ray whose slopes differ by `slopes`.
    float part_askew(float depth, const std::array<float, 2>& slopes, float change) const;

    const BeamFootprint& patch() const { return patch_; }

    /// Places of samples, divided by half the footprint's width along both axes, and the beam's
    /// density there, divided by its maximum. Floats: see eight_floats.h.
    template <class Floats> struct Density {
        Floats x, y, value;
    };

    /// Density where the rays of eight samples reach a depth, which may differ between the samples.
    /// Has no branches, since the processor could not predict them.
    template <class Floats> Density<Floats> density(const Group& group, Floats depth) const;

private:
    template <class Floats> Floats seen_part(Group& group, Floats (&tilts)[2]) const;
    template <class Floats>
    void read(Group& group, Floats (&tilts)[2], Floats (&light)[2], std::size_t first) const;
    template <class Floats> void weigh_with();
    void weigh_with_avx2();
    template <class Floats> float variance_with() const;
    float variance_with_avx2() const;

    void make_room(std::size_t number);

    /// Weight of one sample, indexed by the pixel's sample count n: 1/sqrt(n). So a pixel with more
    /// samples counts more, but not in proportion to n, which would bias the mean towards the light
    /// at the place that this pixel sees.
    using ByNumber = std::array<float, BeamSamples::most_stored + 1>;
    static const ByNumber by_number_;

    BeamFootprint patch_;
    /// Data of an axis for weigh(), each number repeated eight times: the BeamFootprint::Axis, with
    /// max_slope_offset raised to at least half_pixel_slope, and the central ray.
    struct Axis {
        Eight cell_at_sheet, cell_slope, pixel_at_sheet, pixel_slope;
        Eight half_pixel_slope, max_slope_offset, max_lens_distance;
        Eight centre_point, centre_slope;
    };
    Axis axes_[2];
    float tilt_unit_ = 0;
    /// The samples that were added, and their shares (Group::shares).
    std::vector<const BeamSamples::Sample*> added_;
    std::vector<Eight> shares_;
    std::size_t number_ = 0;     ///< of samples that were added
    std::size_t own_number_ = 0; ///< of the pixel's own, which are the first
    std::vector<Group> groups_;
    std::size_t group_number_ = 0;
    HitSamples met_;
    float weight_ = 0, nearest_ = 0, furthest_ = 0;
};

/// Weighted sums of samples' light, or of another number per component (add_pair), component by
/// component, eight samples at a time.
template <class Floats> struct LightSums {
    Floats light[2][2]{};

    INTEGRAL_INLINE void add(Floats weights, const WeightedSamples::HitSamples& hits,
                             std::size_t eight)
    {
        for (int pair = 0; pair < 2; ++pair) {
            Floats more[2];
            hits.light_pair(pair, eight, more);
            add_pair(pair, weights, more);
        }
    }
    INTEGRAL_INLINE void add_pair(int pair, Floats weights, const Floats (&more)[2])
    {
        for (int k = 0; k < 2; ++k)
            light[pair][k] = light[pair][k] + weights * more[k];
    }
    INTEGRAL_INLINE FourFloats sums() const
    {
        return sums_of_eight(light[0][0], light[0][1], light[1][0], light[1][1]);
    }
};

inline void WeightedSamples::add(const BeamSamples::Pixel* pixels, unsigned which,
                                 const Eight& parts)
{
    if (added_.size() < number_ + 8 * BeamSamples::most_stored + 3)
        make_room(number_ + 8 * BeamSamples::most_stored + 3);
    const BeamSamples::Sample** added = added_.data() + number_;
    float* shares = shares_.data()->values + number_;
    for (; which != 0; which &= which - 1) {
        const int k = __builtin_ctz(which);
        const BeamSamples::Pixel& pixel = pixels[k];
        const int number = pixel.number;
        const FourFloats share = FourFloats{} + parts[k] * by_number_[number];
        // Four samples are written at a time; the next pixel's overwrite the surplus ones. A branch
        // would be slow: most pixels have one sample or four, which the processor cannot predict.
        const BeamSamples::Sample* more = number > 1 ? pixel.more : &pixel.first;
        added[0] = &pixel.first;
        for (int i = 0; i < 3; ++i)
            added[i + 1] = more + i;
        std::memcpy(shares, &share, sizeof share);
        for (int done = 4; done < number; done += 4) {
            more += done > 4 ? 4 : 3;
            for (int i = 0; i < 4; ++i)
                added[done + i] = more + i;
            std::memcpy(shares + done, &share, sizeof share);
        }
        added += number;
        shares += number;
    }
    number_ = std::size_t(added - added_.data());
}

template <class Floats>
INTEGRAL_INLINE WeightedSamples::Density<Floats> WeightedSamples::density(const Group& group,
                                                                          Floats depth) const
{
    const Floats far = abs(depth), one = broadcast<Floats>(1), none = broadcast<Floats>(0),
                 two = broadcast<Floats>(2);
    Floats places[2], both_of[2], narrow_of[2], value = one;
    for (int k = 0; k < 2; ++k) {
        const Axis& axis = axes_[k];
        const Floats cell = load<Floats>(axis.cell_at_sheet) + load<Floats>(axis.cell_slope) * far,
                     pixel = abs(load<Floats>(axis.pixel_at_sheet) +
                                 load<Floats>(axis.pixel_slope) * depth),
                     both = cell + pixel;
        places[k] = load<Floats>(group.lines[k]) + depth * load<Floats>(group.lines[k + 2]);
        both_of[k] = both;
        narrow_of[k] = min(cell, pixel) + broadcast<Floats>(least_fall) * both;
    }
    // One division instead of four.
    const Floats products[2] = {both_of[0] * narrow_of[0], both_of[1] * narrow_of[1]},
                 quotient = one / (products[0] * products[1]);
    for (int k = 0; k < 2; ++k) {
        const Floats both = both_of[k], of_both = narrow_of[k] * products[1 - k] * quotient,
                     of_narrow = both * products[1 - k] * quotient,
                     inside = broadcast<Floats>(0.5f) * both - abs(places[k]);
        places[k] = places[k] * (two * of_both);
        value = value * max(min(inside * of_narrow, one), none);
    }
    return {places[0], places[1], value};
}

} // namespace integral

#endif
