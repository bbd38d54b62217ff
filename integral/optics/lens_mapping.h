// SPDX-License-Identifier: AGPL-3.0-or-later
// From a film point to its lens and the ray that leaves it (optics.md sections 3 and 4), and back.
#ifndef INTEGRAL_OPTICS_LENS_MAPPING_H
#define INTEGRAL_OPTICS_LENS_MAPPING_H

#include "integral/optics/aperture.h"
#include "integral/optics/film.h"
#include "integral/optics/lens_model.h"
#include "integral/optics/lens_sheet.h"
#include "integral/optics/refraction.h"
#include "integral/optics/slit.h"

#include <optional>
#include <vector>

namespace integral {

/// How a film point finds its lens (optics.md section 4).
///
/// Searches are limited: `accurate` goes 100 pitches from the lens that sees the aperture's centre,
/// `exhaustive` 1000 pitches from the film point. Only an aperture hundreds of lenses wide, or one
/// that is unlimited in one direction and narrow in the other, has lenses beyond that.
enum class LensMapping {
    automatic, ///< closest, and accurate only where closest's check fails
    closest,   ///< the lens of the nearest pole, if its ray passes the aperture (3-11)
    accurate,  ///< of the lenses whose rays pass the aperture, the one that passes nearest to its
               ///< centre
    exhaustive ///< accurate by trying every lens: the oracle
};

/// The pole ray of a film point: its light beyond the lens's pole. Sheet frame, mm.
struct LensRay {
    LensIndex lens;
    Vec2 pole; ///< where it leaves, on z = 0: the lens's pole, or a point of a lenticular lens's
               ///< axis
    Vec3 direction;      ///< unit, towards the viewer (z < 0)
    Vec2 aperture_point; ///< where it meets the aperture plane z = -distance
};

/// Why a film point images nothing.
enum class Empty { none, outside_aperture, total_reflection };

/// What becomes of one film point.
struct MappedPoint {
    std::optional<LensRay> ray; ///< nothing: no ray is to be traced
    Empty empty = Empty::none;  ///< the reason, if so
    bool searched = false; ///< the nearest lens was not enough; always, by accurate and exhaustive
};

/// The optics of a sheet, a film behind it and an aperture before it: immutable, and shared by
/// every thread of a render.
class SheetOptics {
public:
    /// `sheet` and `aperture` must be within the ranges of their comments; find_errors in camera.h
    /// checks them.
    SheetOptics(const LensSheet& sheet, const Aperture& aperture,
                LensModel model = LensModel::extended_pinhole);

    /// Lens and ray of a film point. One farther than 10^9 pitches from the sheet's centre images
    /// nothing.
    MappedPoint map(Vec2 film_point, LensMapping mapping) const;

    /// The same for the first `number` film points, neighbours at best: the results of `map`, bit
    /// for bit, but several rays are worked out side by side, which is faster.
    void map_run(int number, const RayRun<Vec2>& film_points, LensMapping mapping,
                 RayRun<MappedPoint>& mapped) const;

    /// The ray from a film point through one given lens, whether or not it passes the aperture.
    /// Nothing: totally reflected, or the slit is out of reach.
    std::optional<LensRay> ray_through(Vec2 film_point, LensIndex lens) const;

    /// ray_through of the first `number` film points, bit for bit, worked out side by side.
    void rays_through(int number, const RayRun<Vec2>& film_points, LensIndex lens,
                      RayRun<std::optional<LensRay>>& rays) const;

    /// Inverse for an eye: the film point whose light leaves the sheet at `point` (z = 0) in
    /// `direction` (of any length, towards the viewer, z < 0), through the lens whose cell contains
    /// `point`. The film point's beam fills the cell, so every point of the cell gives the same.
    Vec2 film_point_seen(Vec2 point, Vec3 direction, LensIndex* lens = nullptr) const
    {
        const LensIndex index = lattice_.nearest(point);
        if (lens)
            *lens = index;
        Vec2 base = lattice_.pole(index);
        if (lenticular_)
            base = point + dot(slit_.across, base - point) * slit_.across;
        return base - offset_from_direction(medium_, direction);
    }

    const LensSheet& sheet() const { return sheet_; }
    LensModel model() const { return model_; }
    const Aperture& aperture() const { return aperture_; }
    const Lattice& lattice() const { return lattice_; }
    /// Between film and poles; the model's own index of refraction.
    const Medium& medium() const { return medium_; }
    /// Meaningful for a lenticular sheet only.
    const Slit& slit() const { return slit_; }

private:
    /// The pole ray of a film point through one lens, before its direction is worked out.
    struct Candidate {
        LensIndex lens;
        Vec2 pole;   ///< where it leaves, as in LensRay
        Vec2 offset; ///< q: from the film point to there
        double root; ///< sqrt(t^2 - m |q|^2)
        Vec2 aperture_point;
    };
    bool candidate_at_pole(Vec2 film_point, Candidate& c) const;
    static bool candidate_on_axis(const std::optional<SlitRay>& ray, Candidate& c);
    bool find_candidate(Vec2 film_point, LensIndex lens, Candidate& c) const;
    void find_candidates(int number, const RayRun<Vec2>& film_points,
                         const RayRun<LensIndex>& lenses, RayRun<Candidate>& candidates,
                         RayRun<bool>& found) const;
    std::optional<Candidate> candidate(Vec2 film_point, LensIndex lens) const;
    LensRay complete(const Candidate& c) const
    {
        return {c.lens, c.pole, refracted_at_pole(medium_, c.offset, c.root), c.aperture_point};
    }
    bool passes(Vec2 aperture_point) const { return contains(edges_, aperture_point); }

    MappedPoint map_closest(Vec2 film_point) const;
    MappedPoint map_accurate(Vec2 film_point) const;
    MappedPoint map_exhaustive(Vec2 film_point) const;
    MappedPoint map_by_search(Vec2 film_point) const;
    std::optional<Candidate> best_within(Vec2 film_point, Vec2 centre, double radius) const;
    Empty why_empty(Vec2 film_point) const;
    Vec2 pole_seeing_centre(Vec2 film_point, double& error) const;
    double distance_to_centre(Vec2 aperture_point) const;
    double aperture_circumradius() const;

    void set_neighbour_limits();
    /// About where the film point sees the aperture's centre: pole_seeing_centre, its square root
    /// taken by a series. The lens nearest to there is likely to image the film point.
    Vec2 likely_pole(Vec2 film_point) const
    {
        const double nd = medium_.n * aperture_.distance;
        const double s = likely_bend_ * dot(film_point, film_point);
        const double inverse_root = 1 - s * (0.5 - 0.375 * s); // 1/sqrt(1 + s)
        return (nd / (nd + medium_.t * inverse_root)) * film_point;
    }
    /// Whether a film point is so near to the centre that rounding is far below the margins of
    /// neighbour_limits_.
    bool is_exact(Vec2 film_point) const
    {
        return std::fabs(film_point.x) + std::fabs(film_point.y) < 1e6 * lattice_.pitch();
    }
    /// Which other lenses' rays may pass the aperture besides one lens's.
    struct Rivals {
        int number = 0; ///< 0: none; 1: `lens`; more: not known which
        LensIndex lens;
    };
    Rivals rivals_of(const Candidate& c) const;
    void set(MappedPoint& mapped, const Candidate* image, bool searched) const;
    bool settle(Vec2 film_point, LensIndex nearest, LensMapping mapping, const Candidate& c,
                MappedPoint& mapped) const;
    bool settle_between_two(Vec2 film_point, LensIndex nearest, const Candidate& c,
                            MappedPoint& mapped) const;

    LensSheet sheet_;
    LensModel model_;
    Aperture aperture_;
    Lattice lattice_;
    Medium medium_;
    Slit slit_;
    bool lenticular_, slit_horizontal_;
    Aperture edges_; ///< the aperture, without limit across a slit

    /// Where a lens's ray meets the aperture plane at A with direction.A < limit, the ray of the
    /// neighbour in the opposite direction misses the aperture; and the other way round.
    struct NeighbourLimit {
        Vec2 to_pole;   ///< from a lens's pole (axis) to the neighbour's, mm
        Vec2 direction; ///< in which A moves towards the neighbour's
        double limit;
    };
    /// Empty where no A is within all limits, and for hexagonal sheets, whose cells and apertures
    /// differ so much in shape that few A are.
    std::vector<NeighbourLimit> neighbour_limits_;
    double second_ring_limit_ = 0;   ///< the limit of |A| for all lenses beyond these neighbours
    double alone_limit_ = 0;         ///< of |A|: no other lens's ray passes nearer to the centre
    bool nearest_transmits_ = false; ///< the nearest lens never reflects light totally
    double likely_bend_ = 0;         ///< for likely_pole
};

/// The film point mirrored at a lens's pole (lenticular: at its axis). Its own inverse. A
/// single-stage capture puts on a film point what belongs at the mirrored one, so that the sheet
/// shows its scene inverted in depth.
Vec2 mirrored_in_lens(const SheetOptics& optics, Vec2 film_point, LensIndex lens);

} // namespace integral

#endif
