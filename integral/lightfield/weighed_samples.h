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
    /// The elements of an array, for range-based loops.
    template <class Element> struct Range {
        Element *first, *last;
        Element* begin() const { return first; }
        Element* end() const { return last; }
    };

    /// Begins a pixel. `centre`: the line from its centre through the lens's pole. `samples`: the
    /// store of the samples that will be added; it must outlive weigh().
    void begin(const BeamPatch& patch, const SightSlope& centre, const BeamSamples& samples);

    /// Adds the samples of a pixel, which must not be empty. `part`: their weight, 0 to 1.
    /// `is_own`: it is the pixel itself.
    void add(const BeamSamples::Pixel& pixel, float part, bool is_own);

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

    /// A sample that ended in the beam.
    struct Met {
        FourFloats numbers; ///< its weight, its place in the patch (x, y: -1 to 1), its depth, mm
        float weight() const { return numbers[0]; }
        float depth() const { return numbers[3]; }
        StoredLight light;
        std::uint16_t layer; ///< for the user of the list
    };
    Range<Met> met() { return {met_.data(), met_.data() + met_number_}; }
    Range<const Met> met() const { return {met_.data(), met_.data() + met_number_}; }

    /// Of the samples that ended in the beam: the sum of their weights, the part of it that the
    /// pixel's own have, and their least and greatest depth, mm.
    float weight() const { return weight_; }
    float own_part() const;
    float nearest() const { return nearest_; }
    float furthest() const { return furthest_; }

    const BeamPatch& patch() const { return patch_; }

    /// Where samples are, divided by half the patch's width along both axes, and the beam's
    /// density there, divided by the greatest. Floats: see eight_floats.h.
    template <class Floats> struct Density {
        Floats x, y, value;
    };

    /// The beam's density at one depth, for any number of samples.
    class Section;
    Section section(float depth) const;

private:
    template <class Floats> Density<Floats> density(const Group& group) const;
    template <class Floats> Floats seen_part(Group& group, Floats (&tilts)[2]) const;
    template <class Floats> void read(Group& group, Floats (&tilts)[2], std::size_t first) const;
    template <class Floats> void weigh_with();
    void weigh_with_avx2();

    /// As how much each sample of a pixel counts, by their number. More samples tell more. But if
    /// they counted in full, the mean would lean to where they are.
    using Shares = std::array<float, BeamSamples::most_stored + 1>;
    static const Shares shares_;

    BeamPatch patch_;
    BeamPatch::Axis axes_[2]; ///< those of patch_, but lent_slope is at least half a pixel's slopes
    FourFloats centre_{};
    BeamSamples::Units units_;
    /// The pixels that were added, and their samples, each with the number of its pixel.
    struct Lender {
        FourFloats start{}; ///< its centre's line, less the pixel's own
        float share = 0;
    };
    std::vector<Lender> lenders_;
    std::size_t lender_number_ = 0;
    struct Added {
        const BeamSamples::Sample* sample;
        std::size_t lender;
    };
    std::vector<Added> added_;
    std::size_t number_ = 0;                  ///< of samples in added_
    std::size_t own_begin_ = 0, own_end_ = 0; ///< the pixel's own
    std::vector<Group> groups_;
    std::size_t group_number_ = 0;
    std::vector<Met> met_;
    std::size_t met_number_ = 0;
    float weight_ = 0, nearest_ = 0, furthest_ = 0;
};

inline void WeighedSamples::add(const BeamSamples::Pixel& pixel, float part, bool is_own)
{
    const FourFloats line = {pixel.centre.point[0], pixel.centre.point[1], pixel.centre.slope[0],
                             pixel.centre.slope[1]};
    const std::size_t number = lender_number_++, end = number_ + pixel.number;
    if (lenders_.size() < lender_number_)
        lenders_.resize(2 * lender_number_);
    if (added_.size() < end)
        added_.resize(2 * end);
    // Written where it lies: to copy a finished one would stall until its share is known.
    Lender& lender = lenders_[number];
    lender.start = line - centre_;
    lender.share = part * shares_[pixel.number];
    if (is_own) {
        own_begin_ = number_;
        own_end_ = end;
    }
    Added* added = &added_[number_];
    *added++ = {&pixel.first, number};
    for (int k = 0; k + 1 < pixel.number; ++k)
        *added++ = {&pixel.more[k], number};
    number_ = end;
}

class WeighedSamples::Section {
public:
    Section(const BeamPatch& patch, float depth);

    /// For eight samples: where their lines cross the section.
    template <class Floats> INTEGRAL_INLINE Density<Floats> density(const Group& group) const
    {
        const Floats one = eight_of<Floats>(1), none = eight_of<Floats>(0);
        Floats places[2], value = one;
        for (int k = 0; k < 2; ++k) {
            const Floats place = loaded<Floats>(group.lines[k]) +
                                 eight_of<Floats>(depth_) * loaded<Floats>(group.lines[k + 2]);
            places[k] = eight_of<Floats>(of_reach_[k]) * place;
            const Floats inside = eight_of<Floats>(reach_[k]) - magnitude(place);
            value = value * most(least(eight_of<Floats>(of_narrow_[k]) * inside, one), none);
        }
        return {places[0], places[1], value};
    }

private:
    float depth_;
    float reach_[2], of_reach_[2], of_narrow_[2]; ///< of_: one by
};

} // namespace integral

#endif
