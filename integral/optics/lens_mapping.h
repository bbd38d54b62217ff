// SPDX-License-Identifier: AGPL-3.0-or-later
// Maps a film point to its lens and the ray that leaves it (optics.md sections 3 and 4), and back.
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

/// Rule by which a film point finds its lens (optics.md section 4).
///
/// Searches are limited: `accurate` to 100 pitches from the point of the sheet through which the
/// film point sees the aperture's centre, `exhaustive` to 1000 pitches from the film point. Lenses
/// beyond that matter only for an aperture hundreds of lenses wide, or for one that is unlimited in
/// one direction and narrow in the other.
enum class LensMapping {
    automatic, ///< closest; accurate only if closest finds no ray
    closest,   ///< the lens of the nearest pole, if its ray passes the aperture (3-11)
    accurate,  ///< the lens whose ray passes nearest to the aperture's centre, among those whose
               ///< rays pass the aperture
    exhaustive ///< accurate, by trying every lens: the tests' reference
};

/// The pole ray of a film point: its light beyond the lens's pole. Sheet frame, mm.
struct LensRay {
    LensIndex lens;
    Vec2 pole;           ///< exit on z = 0: the lens's pole, or a point of a lenticular lens's axis
    Vec3 direction;      ///< unit, towards the viewer (z < 0)
    Vec2 aperture_point; ///< intersection with the aperture plane z = -distance
};

/// The reason why no lens images a film point.
enum class Empty { none, outside_aperture, total_reflection };

/// Result of mapping one film point.
struct MappedPoint {
    std::optional<LensRay> ray; ///< empty: no ray is to be traced
    Empty empty = Empty::none;  ///< the reason, if there is no ray
    bool searched = false; ///< the nearest lens did not suffice; always with accurate, exhaustive
};

/// The optics of a sheet, a film behind it and an aperture before it: immutable, shared by all
/// threads of a render.
class SheetOptics {
public:
    /// `sheet` and `aperture` must be within the ranges of their comments; find_errors in
    /// camera_parameters.h checks them.
    SheetOptics(const LensSheet& sheet, const Aperture& aperture,
                LensModel model = LensModel::extended_pinhole);

    /// Maps film points only if their ray meets the aperture plane in a part of the viewing zone or
    /// up to `margin` (fraction of the zone) beyond. Call it before the object is shared.
    void restrict_to(const ZonePhase& phase, double margin);

    /// Lens and ray of a film point. No lens images a film point more than 10^9 pitches from the
    /// sheet's centre.
    MappedPoint map(Vec2 film_point, LensMapping mapping) const;

    /// Calls map() for the first `number` film points, preferably neighbours. Results are the same
    /// bit for bit, but several rays are computed side by side, which is faster.
    void map_run(int number, const RayRun<Vec2>& film_points, LensMapping mapping,
                 RayRun<MappedPoint>& mapped) const;

    /// The ray from a film point through one given lens, whether or not it passes the aperture.
    /// Empty if the light is totally reflected or cannot reach the slit.
    std::optional<LensRay> ray_through(Vec2 film_point, LensIndex lens) const;

    /// Computes ray_through for the first `number` film points side by side, bit for bit the same.
    void rays_through(int number, const RayRun<Vec2>& film_points, LensIndex lens,
                      RayRun<std::optional<LensRay>>& rays) const;

    /// Inverse of map(): the film point whose light leaves the sheet at `point` (z = 0) in
    /// `direction` (of any length, towards the viewer, z < 0), through the lens whose cell contains
    /// `point`. The point's beam fills the cell, so every `point` of the cell gives the same.
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
    /// The medium between film and poles; has the model's index of refraction.
    const Medium& medium() const { return medium_; }
    /// Meaningful for a lenticular sheet only.
    const Slit& slit() const { return slit_; }

private:
    /// The pole ray of a film point through one lens, before its direction is computed.
    struct Candidate {
        LensIndex lens;
        Vec2 pole;   ///< exit point, as in LensRay
        Vec2 offset; ///< q: from the film point to the exit point
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

    MappedPoint find(Vec2 film_point, LensMapping mapping) const;
    void keep_phase(MappedPoint& mapped) const
    {
        if (mapped.ray && !phase_->contains(mapped.ray->aperture_point, zone_, phase_margin_))
            mapped = {std::nullopt, Empty::outside_aperture, mapped.searched};
    }
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
    /// Approximate point through which the film point sees the aperture's centre:
    /// pole_seeing_centre with a series for the square root. The lens nearest to it is likely to
    /// image the film point.
    Vec2 likely_pole(Vec2 film_point) const
    {
        const double nd = medium_.n * aperture_.distance;
        const double s = likely_bend_ * dot(film_point, film_point);
        const double inverse_root = 1 - s * (0.5 - 0.375 * s); // 1/sqrt(1 + s)
        return (nd / (nd + medium_.t * inverse_root)) * film_point;
    }
    /// Whether a film point is near enough to the centre for rounding to be far below the margins
    /// of neighbour_limits_.
    bool is_exact(Vec2 film_point) const
    {
        return std::fabs(film_point.x) + std::fabs(film_point.y) < 1e6 * lattice_.pitch();
    }
    /// The lenses, besides a given one, whose rays may pass the aperture.
    struct Rivals {
        int number = 0; ///< 0: none; 1: `lens`; more: it is not known which
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

    /// A lens has a neighbour at to_pole and one at -to_pole. If the lens's ray meets the aperture
    /// plane at A, and direction.A < limit, the ray of the neighbour at -to_pole misses the
    /// aperture; if direction.A > -limit, that of the neighbour at to_pole does.
    struct NeighbourLimit {
        Vec2 to_pole;   ///< from a lens's pole (axis) to a neighbour's, mm
        Vec2 direction; ///< in which A moves from the lens to that neighbour
        double limit;
    };
    /// Empty if no A is within all limits, and for hexagonal sheets, whose cells and apertures
    /// differ so much in shape that few A would be.
    std::vector<NeighbourLimit> neighbour_limits_;
    double second_ring_limit_ = 0;   ///< the limit of |A| for all lenses beyond these neighbours
    double alone_limit_ = 0;         ///< if |A| is less, no other lens's ray is nearer the centre
    bool nearest_transmits_ = false; ///< the nearest lens never reflects light totally
    double likely_bend_ = 0;         ///< for likely_pole
    std::optional<ZonePhase> phase_; ///< nothing: the whole zone
    Vec2 zone_;                      ///< width and height of the viewing zone, mm
    double phase_margin_ = 0;
};

/// The film point mirrored at a lens's pole (lenticular: at its axis). Its own inverse. A
/// single-stage capture records at a film point what belongs at the mirrored point, so that the
/// sheet shows the scene inverted in depth.
Vec2 mirrored_in_lens(const SheetOptics& optics, Vec2 film_point, LensIndex lens);

} // namespace integral

#endif
