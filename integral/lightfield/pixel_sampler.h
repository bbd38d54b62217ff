// SPDX-License-Identifier: AGPL-3.0-or-later
// Which rays make up a pixel of the film: samples of its area and of its lens's cell, together the
// four dimensions of the light that it stands for (optics.md section 3, thesis 4.3.8).
#ifndef INTEGRAL_LIGHTFIELD_PIXEL_SAMPLER_H
#define INTEGRAL_LIGHTFIELD_PIXEL_SAMPLER_H

#include "integral/lightfield/sample_points.h"
#include "integral/optics/camera.h"

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

/// What became of a pixel's film points: one, or three with a film of subpixels. The last two
/// counts add up to film_points - imaged.
struct PixelOutcome {
    int film_points = 0, imaged = 0;
    int searched = 0; ///< of the imaged, those whose lens the accurate search found
    int outside_aperture = 0;
    int total_reflection = 0; ///< also: no ray of the lens model got through
    LensIndex lens;           ///< of the imaged; with subpixels the middle one's, if it is imaged
};

/// The outcome of a pixel that has one film point.
PixelOutcome outcome_of(const MappedPoint& mapped);

/// A pixel and its lens, from which anti-aliasing draws sample after sample.
struct PixelBeam {
    struct Channel {
        int channel;      ///< as in PixelRay
        Vec2 film_centre; ///< mm
        LensIndex lens;
        bool whole; ///< the lens has all of the pixel's area
        PointSeeds seeds;
        SumSplit across, along; ///< the lens: how places on the cell (first) and on the pixel share
                                ///< in what is seen at the depth aimed at
        bool turned = false; ///< it is the place on the pixel's height that counts across the lens
    };
    std::array<Channel, 3> channels;
    int number = 0; ///< of channels that are imaged
};

/// Chooses the rays of pixels. Immutable, shared by all threads; what it chooses depends on the
/// pixel's centre and the seed alone.
class PixelSampler {
public:
    /// Refers to `camera`, which must outlive it.
    PixelSampler(const IntegralCamera& camera, std::uint64_t seed);

    /// Appends the rays of the pixel (or sample of a pixel) whose centre is at `centre`, in pixels
    /// from the film's top left corner: pixel_samples * beam_samples of them a channel (hybrid:
    /// pixel_samples times 3 or 5), less the samples that another lens images, or none. Where that
    /// leaves no sample, the centre stands in for all. With the display prefilter no sample is
    /// another lens's. No rays where the centre images nothing.
    PixelOutcome append_rays(Vec2 centre, std::vector<PixelRay>& rays) const;

    /// Whether append_rays appends at most one ray a pixel, its pole's: what `one_ray` gives, with
    /// what became of it in `outcome`.
    bool gives_one_ray() const { return one_ray_; }
    std::optional<BeamRay> one_ray(Vec2 centre, PixelOutcome& outcome) const;

    /// The ray of the pixel's centre through its lens's pole, by the lens model. Nothing where
    /// there is none.
    std::optional<BeamRay> pole_ray(Vec2 centre) const;

    /// Appends one ray (a channel) of the same pixel, at random over both its area and the lens's
    /// cell, independent for each `index`: the mean over all of them is the converged 4-D
    /// reference. hybrid is judged by full. Where the lens has next to nothing of the pixel, the
    /// centre may stand in for its area. False where no light gets through the lens.
    bool append_random_ray(Vec2 centre, std::uint64_t index, std::vector<PixelRay>& rays) const;

    /// The beam of the pixel whose centre is at `centre`. `alike`: the samples are chosen alike in
    /// every pixel, else each pixel has its own. `depth`: of what the pixel shows, mm from the
    /// sheet away from the viewer; infinite, too. Its samples are spread evenly over what the beam
    /// covers there: at the sheet the lens's cell, far from it the pixel's area, and both together
    /// in between. Whatever the depth, they are uniform over both.
    PixelBeam beam(Vec2 centre, bool alike, double depth) const;

    /// Appends one ray (a channel) of a beam: sample `index` of a sequence whose first 4^k points
    /// are spread evenly. hybrid is sampled as full. None where the sample is another lens's, or no
    /// light gets through.
    void append_sample(const PixelBeam& beam, std::uint32_t index,
                       std::vector<PixelRay>& rays) const;

    /// Whether append_rays samples all that the reference is the mean over, in two independent
    /// halves, so that their difference tells the whole error: at least 16 samples, and more than
    /// one of both kinds.
    bool halves_tell_error() const;

private:
    struct UnitPoint {
        Vec2 pixel{0.5, 0.5}, lens{0.5, 0.5};
    };
    UnitPoint even_point(std::uint64_t key, int index, int& half) const;
    std::uint64_t pixel_key(Vec2 centre) const;
    double random_shift(std::uint64_t key, std::uint64_t index, int dimension) const;
    Vec2 channel_centre(Vec2 centre, int channel) const;
    Vec2 moved(Vec2 film_point, Vec2 unit) const;
    std::optional<LensRay> sample_ray(Vec2 film_point, LensIndex lens) const;
    void aim(PixelBeam::Channel& own, const LensRay& pole_ray, double depth) const;
    LensPoint lens_point(Vec2 unit, const LensRay& pole_ray) const;
    void append_channel(Vec2 centre, int channel, std::uint64_t key, std::vector<PixelRay>& rays,
                        PixelOutcome& outcome) const;
    void append_ray(Vec2 film_point, const LensRay& pole_ray, const LensPoint& point, PixelRay ray,
                    std::vector<PixelRay>& rays) const;

    const IntegralCamera& camera_;
    std::uint64_t seed_;
    std::vector<WeightedLensPoint> hybrid_; ///< empty for other models
    Vec2 area_;                             ///< mm, of a pixel or of its subpixels
    int film_dimensions_, lens_dimensions_; ///< over which append_rays spreads its samples
    int cell_dimensions_;                   ///< of a lens's cell: 1 where it is a line, else 2
    bool one_ray_;                          ///< a pixel, that of its centre through the pole
};

} // namespace integral

#endif
