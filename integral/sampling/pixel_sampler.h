// SPDX-License-Identifier: AGPL-3.0-or-later
// Chooses the rays of a film pixel: samples of the pixel's area and of its lens's cell, which are
// the four dimensions over which a pixel integrates light (optics.md section 3, thesis 4.3.8).
#ifndef INTEGRAL_SAMPLING_PIXEL_SAMPLER_H
#define INTEGRAL_SAMPLING_PIXEL_SAMPLER_H

#include "integral/optics/camera.h"
#include "integral/sampling/sample_points.h"

#include <array>
#include <cstdint>
#include <vector>

namespace integral {

/// One ray of a pixel. A channel's colour is the weighted mean, in linear light, over the rays of
/// that channel.
struct PixelRay {
    static constexpr int all_channels = -1;
    BeamRay ray;
    double weight = 1;
    int channel = all_channels; ///< or 0 red, 1 green, 2 blue, with a film of subpixels
    int half = 0;               ///< 0 or 1: which of two independent sets of samples it belongs to
};

/// Counts of a pixel's film points (one, or three on a film of subpixels): of those that a lens
/// images, and of the others by cause. outside_aperture + total_reflection = film_points - imaged.
struct PixelOutcome {
    int film_points = 0, imaged = 0;
    int searched = 0; ///< number of imaged points whose lens the accurate search found
    int outside_aperture = 0;
    int total_reflection = 0; ///< includes points from which no ray of the lens model gets through
    LensIndex lens;           ///< lens of the imaged point; with subpixels, that of green, or that
                              ///< of red if green is not imaged
};

/// The outcome of a pixel that has one film point.
PixelOutcome outcome_of(const MappedPoint& mapped);

/// A pixel and its lens, prepared for taking one sample after another.
struct PixelBeam {
    struct Channel {
        int channel;      ///< as in PixelRay
        Vec2 film_centre; ///< mm
        LensIndex lens;
        bool whole;           ///< the lens images all of the pixel's area
        ShiftedPoints points; ///< sample points, for beam()'s `depth`
        SumSplit across,
            along;           ///< across and along the lens: how the position on the cell (first)
                             ///< and on the pixel (second) move the point seen at the beam's depth
        bool turned = false; ///< the pixel's height, not its width, lies across the lens
    };
    std::array<Channel, 3> channels;
    int number = 0; ///< number of imaged channels
};

/// Chooses the rays of pixels. Immutable and shared by all threads. The choice depends only on a
/// pixel's centre and the seed.
class PixelSampler {
public:
    /// Refers to `camera`, which must outlive the sampler.
    PixelSampler(const IntegralCamera& camera, std::uint64_t seed);

    /// Appends the rays of the pixel (or sample of a pixel) with the given centre, in pixels from
    /// the film's top left corner. There are pixel_samples * beam_samples rays per channel (hybrid:
    /// pixel_samples times 3 or 5), but samples that another lens images, or none, are left out. If
    /// no sample remains, the centre is sampled instead. With the display prefilter all samples
    /// belong to the pixel's lens. No rays if no lens images the centre.
    PixelOutcome append_rays(Vec2 centre, std::vector<PixelRay>& rays) const;

    /// Whether append_rays appends at most one ray per pixel, the pole ray. Then one_ray returns
    /// that ray and sets `outcome`, at less cost.
    bool gives_one_ray() const { return one_ray_; }
    std::optional<BeamRay> one_ray(Vec2 centre, PixelOutcome& outcome) const;

    /// The ray from the pixel's centre through its lens's pole, by the lens model; nothing if there
    /// is none.
    std::optional<BeamRay> pole_ray(Vec2 centre) const;

    /// The first sample of the beam of a pixel that has one film point: sample 0 of beam() and
    /// append_sample. It does not depend on the depth. The first samples of the pixels behind a
    /// lens are well distributed over cell and area together: the samples of 2^k x 2^k pixels are
    /// like 4^k samples of one pixel. `pole_ray`: of the pixel's centre. Returns the pole ray
    /// itself if the sample belongs to another lens, or if no light gets through.
    BeamRay first_sample(Vec2 centre, const LensRay& pole_ray, bool same_pattern) const;

    /// The first samples of run_length pixels of a row, from the left, skipping pixels that are not
    /// imaged. They equal first_sample's, bit for bit, but all film points are mapped at once.
    /// `centre`: of the first pixel. `mapped`: the pixels' mapped centres. Not with
    /// display_prefilter.
    void first_samples(Vec2 centre, const RayRun<MappedPoint>& mapped, bool same_pattern,
                       RayRun<BeamRay>& samples) const;

    /// Appends one ray per channel of the pixel with the given centre, at a random point of the
    /// pixel's area and of the lens's cell: ray `index` of a `set`. The rays of one set are well
    /// distributed; different sets are independent. The mean over many rays converges to the 4-D
    /// reference. For hybrid the reference is the full model. If the lens images only a tiny part
    /// of the pixel, the pixel's centre may be used instead of a random point. Returns false if no
    /// light gets through the lens.
    bool append_reference_ray(Vec2 centre, std::uint64_t set, std::uint32_t index,
                              std::vector<PixelRay>& rays) const;

    /// The beam of the pixel with the given centre. `same_pattern`: use the same sample pattern in
    /// every pixel; otherwise the pixels behind a lens share a sequence, shifted for each pixel so
    /// that it begins with the pixel's first sample. `depth`: distance of the surface that the
    /// pixel shows, mm from the sheet away from the viewer; may be infinite. The samples are well
    /// distributed over the beam's footprint at that depth: the lens's cell at the sheet, the
    /// pixel's area far away, and a combination of both in between. At any depth the samples are
    /// uniform over cell and area. `around`: the lens, if it is known to image the pixel and all
    /// pixels around it (LightFieldImage::lens_around): the same beam is then computed without a
    /// search. Must be empty on a film of subpixels.
    PixelBeam beam(Vec2 centre, bool same_pattern, double depth,
                   std::optional<LensIndex> around = {}) const;

    /// Appends one ray per channel of a beam: sample `index` of a sequence whose first 4^k points
    /// are well distributed. hybrid is sampled like full. Appends nothing if the sample belongs to
    /// another lens or no light gets through.
    void append_sample(const PixelBeam& beam, std::uint32_t index,
                       std::vector<PixelRay>& rays) const;

    /// The rays of samples `begin` to begin + number - 1 of one channel of a beam, `number` at most
    /// run_length. They equal append_sample's, but are computed side by side. Nothing for a sample
    /// for which append_sample appends nothing.
    void samples(const PixelBeam::Channel& channel, std::uint32_t begin, int number,
                 RayRun<std::optional<BeamRay>>& rays) const;

    /// Whether the difference between append_rays' two independent halves of samples estimates the
    /// whole error. It does if append_rays samples both the pixel's area and the lens's cell, with
    /// at least 16 samples in all.
    bool halves_tell_error() const;

private:
    struct PixelPoint {
        Vec2 pixel{0.5, 0.5}, lens{0.5, 0.5};
    };
    PixelPoint even_point(std::uint64_t key, int index, int& half) const;
    std::uint64_t pixel_key(Vec2 centre) const;
    double random_shift(std::uint64_t key, std::uint64_t index, int dimension) const; // in [0, 1)
    Vec2 channel_centre(Vec2 centre, int channel) const;
    /// The film point at coordinates `unit`, in the unit square, of the area of the pixel (or
    /// subpixel) centred at `film_point`.
    Vec2 moved(Vec2 film_point, Vec2 unit) const
    {
        if (camera_.display_prefilter)
            unit = {tent_coordinate(unit.x), tent_coordinate(unit.y)};
        return {film_point.x + (unit.x - 0.5) * area_.x, film_point.y + (unit.y - 0.5) * area_.y};
    }
    std::optional<LensRay> sample_ray(Vec2 film_point, LensIndex lens) const;
    /// The sequences that the pixels behind a lens share: one for the shifted points, and one for
    /// the first points of each square of pixels.
    static constexpr std::uint64_t shifted_points = 0, first_points = 1;
    PointSeeds lens_seeds(LensIndex lens, int channel, std::uint64_t sequence) const;
    BeamRay first_ray(const LensRay& pole_ray, Vec2 film_point, const UnitPoint& unit,
                      const std::optional<LensRay>& at) const;
    struct PlaceInSequence {
        LensIndex lens; ///< whose sequence it is
        std::uint64_t sequence;
        std::uint32_t index;
    };
    PlaceInSequence place_of_first(Vec2 film_centre, LensIndex lens, bool same_pattern) const;
    UnitPoint first_point(Vec2 film_centre, LensIndex lens, int channel, bool same_pattern) const;
    /// Pole rays from which a beam is computed.
    struct PoleRays {
        std::optional<LensRay> centre, right, up;
        bool whole = false; ///< PixelBeam::Channel::whole
    };
    PoleRays pole_rays_searched(Vec2 film_centre) const;
    PoleRays pole_rays_through(Vec2 film_centre, LensIndex lens) const;
    void aim(PixelBeam::Channel& own, const LensRay& centre, const LensRay& right,
             const LensRay& up, double depth) const;
    LensPoint lens_point(Vec2 unit, const LensRay& pole_ray) const;
    void beam_samples(const PixelBeam::Channel& own, int number, const RayRun<Vec2>& film_points,
                      const RayRun<Vec2>& units, RayRun<std::optional<BeamRay>>& rays) const;
    void append_channel(Vec2 centre, int channel, std::uint64_t key, std::vector<PixelRay>& rays,
                        PixelOutcome& outcome) const;
    std::optional<BeamRay> ray_at(Vec2 film_point, const LensRay& pole_ray,
                                  const LensPoint& point) const;
    void append_ray(Vec2 film_point, const LensRay& pole_ray, const LensPoint& point, PixelRay ray,
                    std::vector<PixelRay>& rays) const;

    const IntegralCamera& camera_;
    std::uint64_t seed_;
    std::vector<WeightedLensPoint> hybrid_; ///< empty for other models
    Vec2 area_;                             ///< size of a pixel or of its subpixels, mm
    int film_dimensions_, lens_dimensions_; ///< sampled by append_rays, 0 to 2 each
    bool one_ray_;                          ///< see gives_one_ray
    std::optional<double> slit_height_;     ///< mm; nothing if it may depend on the pole ray
};

} // namespace integral

#endif
