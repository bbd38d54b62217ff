// SPDX-License-Identifier: AGPL-3.0-or-later
// Weighs the samples of many pixels for one pixel: by the density of its beam at the place that
// each sample met, and by how the surface there lies to the beam.
//
// A frame has hundreds of such samples for each of its pixels, so that this is where
// reconstruction spends its time. Eight samples are worked on side by side.
#ifndef INTEGRAL_LIGHTFIELD_WEIGHED_SAMPLES_H
#define INTEGRAL_LIGHTFIELD_WEIGHED_SAMPLES_H

#include "integral/lightfield/beam_patch.h"
#include "integral/lightfield/eight_floats.h"

#include <vector>

namespace integral {

class WeighedSamples {
public:
    // The density of a beam falls to 0 over the narrower of its two widths, or over this part of
    // both together, so that one that has no width does not divide by 0.
    static constexpr float least_fall = 1e-4f;

    /// The elements of an array, for range-based loops.
    template <class Element> struct Range {
        Element *first, *last;
        Element* begin() const { return first; }
        Element* end() const { return last; }
    };

    /// Begins a pixel. `centre`: the line from its centre through the lens's pole. `samples`: the
    /// store of the samples that will be added; it must outlive weigh().
    void begin(const BeamPatch& patch, const SightSlope& centre, const BeamSamples& samples);

    /// Adds the pixel's own samples, before those of others.
    void add_own(const BeamSamples::Pixel& pixel)
    {
        add(&pixel, 1, {{1}});
        own_number_ = number_;
    }
    /// Adds the samples of those of eight pixels beside each other whose bit of `which` is set;
    /// they must not be empty. `parts`: their weights, 0 to 1.
    void add(const BeamSamples::Pixel* pixels, unsigned which, const Eight& parts);

    /// Works out the weights of all samples that were added, and lists those that have one.
    void weigh();

    /// Eight samples side by side; the last group of a pixel is filled up with samples whose share
    /// is 0.
    struct Group {
        /// Their lines, less the centre's: point x, y (mm), slope x, y.
        Eight lines[4];
        Eight depths;  ///< mm
        Eight areas;   ///< in which the samples' surfaces are seen from the pixel's direction,
                       ///< divided by those from the samples' own; below 0: the other side
        Eight shares;  ///< as which the samples count inside the beam
        Eight weights; ///< the shares times the beam's density where the samples ended, times the
                       ///< part of their surfaces that the pixel sees
    };
    Range<const Group> groups() const { return {groups_.data(), groups_.data() + group_number_}; }

    /// The samples that ended in the beam. They are read eight at a time; the last eight are filled
    /// up with samples whose weight is 0.
    class Met {
    public:
        std::size_t number() const { return number_; }
        std::size_t eights() const { return (number_ + 7) / 8; }

        /// Of eight samples, each number from a column of its own.
        template <class Floats> INTEGRAL_INLINE Floats weights(std::size_t eight) const
        {
            return column<Floats>(of_weights, eight);
        }
        /// The places in the patch, -1 to 1, along both axes (0 and 1).
        template <class Floats> INTEGRAL_INLINE Floats places(int axis, std::size_t eight) const
        {
            return column<Floats>(axis == 0 ? of_x : of_y, eight);
        }
        /// mm
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
        /// The light of such a pair, divided by StoredLight::of_squared_root.
        template <class Floats>
        INTEGRAL_INLINE void light_pair(int pair, std::size_t eight, Floats (&light)[2]) const
        {
            root_pair(pair, eight, light);
            for (Floats& root : light)
                root = root * magnitude(root);
        }

    private:
        friend class WeighedSamples;
        enum Column { of_weights, of_x, of_y, of_depths, of_red_and_green, of_blue_and_more, all };
        template <class Floats> INTEGRAL_INLINE Floats column(Column which, std::size_t eight) const
        {
            return loaded<Floats>(columns_[which].data() + 8 * eight);
        }
        std::array<std::vector<float>, all> columns_;
        std::size_t number_ = 0;
    };
    const Met& met() const { return met_; }

    /// Of the samples that ended in the beam: the sum of their weights, the part of it that the
    /// pixel's own have, and their least and greatest depth, mm.
    float weight() const { return weight_; }
    float own_part() const;
    float nearest() const { return nearest_; }
    float furthest() const { return furthest_; }

    /// The variance of the samples that ended in the beam, of which there must be some: of the
    /// square roots of their light, summed over red, green and blue.
    float variance() const;

    /// Of the samples that ended in the beam nearer than a depth (mm), the part by weight whose
    /// surfaces lie askew: from a line whose slopes differ by `slopes`, the area in which they are
    /// seen is larger or smaller by `change` (a part of it) or more.
    float part_askew(float depth, const std::array<float, 2>& slopes, float change) const;

    const BeamPatch& patch() const { return patch_; }

    /// Where samples are, divided by half the patch's width along both axes, and the beam's
    /// density there, divided by the greatest. Floats: see eight_floats.h.
    template <class Floats> struct Density {
        Floats x, y, value;
    };

    /// For eight samples: where their lines reach a depth, which may be another one for each.
    /// Without branches, which the processor could not predict.
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

    /// As how much each sample of a pixel counts, by their number. More samples tell more. But if
    /// they counted in full, the mean would lean to where they are.
    using ByNumber = std::array<float, BeamSamples::most_stored + 1>;
    static const ByNumber by_number_;

    BeamPatch patch_;
    /// What weigh() reads of an axis, each number eight times: BeamPatch::Axis, but lent_slope is
    /// at least half a pixel's slopes; and the centre's line.
    struct Axis {
        Eight cell_at_sheet, cell_slope, pixel_at_sheet, pixel_slope;
        Eight half_pixel_slope, lent_slope, lent_way;
        Eight centre_point, centre_slope;
    };
    Axis axes_[2];
    float tilt_unit_ = 0;
    /// The samples that were added, and as how much they count inside the beam.
    std::vector<const BeamSamples::Sample*> added_;
    std::vector<Eight> shares_;
    std::size_t number_ = 0;     ///< of samples that were added
    std::size_t own_number_ = 0; ///< of the pixel's own, which are the first
    std::vector<Group> groups_;
    std::size_t group_number_ = 0;
    Met met_;
    float weight_ = 0, nearest_ = 0, furthest_ = 0;
};

/// Sums of samples' light by weight, component by component, eight samples at a time; or of other
/// numbers of each component.
template <class Floats> struct LightSums {
    Floats light[2][2]{};

    INTEGRAL_INLINE void add(Floats weights, const WeighedSamples::Met& met, std::size_t eight)
    {
        for (int pair = 0; pair < 2; ++pair) {
            Floats more[2];
            met.light_pair(pair, eight, more);
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

inline void WeighedSamples::add(const BeamSamples::Pixel* pixels, unsigned which,
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
        // Four samples are written at a time, and what is too much is overwritten by the next
        // pixel's: most pixels have one sample or four, which the processor cannot predict.
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
INTEGRAL_INLINE WeighedSamples::Density<Floats> WeighedSamples::density(const Group& group,
                                                                        Floats depth) const
{
    const Floats far = magnitude(depth), one = eight_of<Floats>(1), none = eight_of<Floats>(0),
                 two = eight_of<Floats>(2);
    Floats places[2], both_of[2], narrow_of[2], value = one;
    for (int k = 0; k < 2; ++k) {
        const Axis& axis = axes_[k];
        const Floats cell = loaded<Floats>(axis.cell_at_sheet) +
                            loaded<Floats>(axis.cell_slope) * far,
                     pixel = magnitude(loaded<Floats>(axis.pixel_at_sheet) +
                                       loaded<Floats>(axis.pixel_slope) * depth),
                     both = cell + pixel;
        places[k] = loaded<Floats>(group.lines[k]) + depth * loaded<Floats>(group.lines[k + 2]);
        both_of[k] = both;
        narrow_of[k] = least(cell, pixel) + eight_of<Floats>(least_fall) * both;
    }
    // One division in place of four.
    const Floats products[2] = {both_of[0] * narrow_of[0], both_of[1] * narrow_of[1]},
                 quotient = one / (products[0] * products[1]);
    for (int k = 0; k < 2; ++k) {
        const Floats both = both_of[k], of_both = narrow_of[k] * products[1 - k] * quotient,
                     of_narrow = both * products[1 - k] * quotient,
                     inside = eight_of<Floats>(0.5f) * both - magnitude(places[k]);
        places[k] = places[k] * (two * of_both);
        value = value * most(least(inside * of_narrow, one), none);
    }
    return {places[0], places[1], value};
}

} // namespace integral

#endif
