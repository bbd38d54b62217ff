// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/optics/lens_mapping.h"

#include <limits>

namespace integral {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// In pitches: beyond this, rounding loses the place within a lens, and counts of lenses overflow.
constexpr double farthest_film = 1e9;
/// Margin for rounding, by which least distances between lenses' rays at the aperture are reduced.
constexpr double limits_margin = 1e-6;

Slit slit_of(const LensSheet& sheet, const Lattice& lattice, double distance)
{
    Slit slit;
    slit.axis = lattice.along();
    slit.across = lattice.across();
    slit.normal = slit_is_horizontal(sheet) ? Vec2{0, 1} : Vec2{1, 0};
    if (dot(slit.normal, slit.axis) < 0)
        slit.normal = -1 * slit.normal;
    slit.distance = distance;
    return slit;
}

} // namespace

SheetOptics::SheetOptics(const LensSheet& sheet, const Aperture& aperture, LensModel model)
    : sheet_(sheet),
      model_(model),
      aperture_(aperture),
      lattice_(sheet),
      medium_(sheet.thickness, modelled_sheet(sheet, model).ior),
      slit_(slit_of(sheet, lattice_, aperture.distance)),
      lenticular_(sheet.arrangement == Arrangement::lenticular),
      slit_horizontal_(slit_is_horizontal(sheet)),
      edges_(aperture)
{
    if (lenticular_)
        (slit_horizontal_ ? edges_.height : edges_.width) = infinity;
    set_neighbour_limits();
}

/// The point A, where a film point's ray meets the aperture plane, moves along with the pole x from
/// lens to lens: (A' - A).(x' - x) >= s |x' - x|^2, s = 1 + n d/t, as A is the gradient of a
/// function of x whose curvature is at least s. With v = (x' - x)/p, the ray of the lens at x'
/// passes the aperture only if v.A + s p |v|^2 is at most the greatest v.A' of all points A' of the
/// aperture.
void SheetOptics::set_neighbour_limits()
{
    const double nd = medium_.n * aperture_.distance, reach = nd + medium_.t;
    likely_bend_ = medium_.m / (reach * reach);
    const double spacing = (1 + nd / medium_.t) * lattice_.pitch() * (1 - limits_margin);
    alone_limit_ = 0.5 * spacing - 4 * lattice_.tie_tolerance();

    const Vec2 across = lattice_.across(), along = lattice_.along();
    const Vec2 edge{0.5 * aperture_.width * inclusive_edge,
                    0.5 * aperture_.height * inclusive_edge};
    const auto add = [&](Vec2 v, Vec2 direction) {
        const double extent = edge.x * std::fabs(direction.x) + edge.y * std::fabs(direction.y);
        neighbour_limits_.push_back(
            {lattice_.pitch() * v, direction, dot(v, v) * spacing - extent});
    };
    if (lenticular_) // A is on the slit, along which axes are at least a pitch apart
        add(across, slit_horizontal_ ? Vec2{std::copysign(1.0, across.x), 0}
                                     : Vec2{0, std::copysign(1.0, across.y)});
    else if (lattice_.arrangement() == Arrangement::square)
        for (const Vec2 v : {across, along, across + along, across - along})
            add(v, v);
    constexpr double second_ring = 2; // pitches to the nearest of all other lenses
    second_ring_limit_ = second_ring * spacing - aperture_circumradius() * inclusive_edge;
    bool useful = second_ring_limit_ > 0;
    for (const NeighbourLimit& neighbour : neighbour_limits_)
        useful = useful && neighbour.limit > 0;
    if (!useful)
        neighbour_limits_.clear();

    const double g = lenticular_ ? dot(slit_.normal, slit_.axis) : 1,
                 farthest = cell_circumradius(sheet_);
    nearest_transmits_ = medium_.m * farthest * farthest <
                         medium_.t * medium_.t * g * g * (1 - limits_margin);
}

inline bool SheetOptics::candidate_at_pole(Vec2 film_point, Candidate& c) const
{
    c.offset = c.pole - film_point;
    const double clear = clearance(medium_, c.offset);
    if (!(clear > 0))
        return false;
    c.root = std::sqrt(clear);
    c.aperture_point = c.pole + (medium_.n * aperture_.distance / c.root) * c.offset;
    return true;
}

inline bool SheetOptics::candidate_on_axis(const std::optional<SlitRay>& ray, Candidate& c)
{
    if (!ray)
        return false;
    c.pole = ray->point;
    c.offset = ray->offset;
    c.root = -ray->refracted.z;
    c.aperture_point = ray->aperture_point;
    return true;
}

/// Fills in `c`. Returns false if the light is totally reflected or cannot reach the slit.
bool SheetOptics::find_candidate(Vec2 film_point, LensIndex lens, Candidate& c) const
{
    c.lens = lens;
    c.pole = lattice_.pole(lens);
    return lenticular_ ? candidate_on_axis(slit_ray(slit_, medium_, film_point, c.pole), c)
                       : candidate_at_pole(film_point, c);
}

/// find_candidate for the first `number` film points, side by side.
void SheetOptics::find_candidates(int number, const RayRun<Vec2>& film_points,
                                  const RayRun<LensIndex>& lenses, RayRun<Candidate>& candidates,
                                  RayRun<bool>& found) const
{
    RayRun<Vec2> poles;
    for (int k = 0; k < number; ++k) {
        candidates[k].lens = lenses[k];
        candidates[k].pole = poles[k] = lattice_.pole(lenses[k]);
    }
    if (!lenticular_) {
        for (int k = 0; k < number; ++k)
            found[k] = candidate_at_pole(film_points[k], candidates[k]);
        return;
    }
    RayRun<std::optional<SlitRay>> rays;
    slit_rays(slit_, medium_, number, film_points, poles, {}, rays);
    for (int k = 0; k < number; ++k)
        found[k] = candidate_on_axis(rays[k], candidates[k]);
}

std::optional<SheetOptics::Candidate> SheetOptics::candidate(Vec2 film_point, LensIndex lens) const
{
    Candidate c;
    return find_candidate(film_point, lens, c) ? std::optional(c) : std::nullopt;
}

std::optional<LensRay> SheetOptics::ray_through(Vec2 film_point, LensIndex lens) const
{
    const auto c = candidate(film_point, lens);
    if (!c)
        return std::nullopt;
    return complete(*c);
}

void SheetOptics::rays_through(int number, const RayRun<Vec2>& film_points, LensIndex lens,
                               RayRun<std::optional<LensRay>>& rays) const
{
    RayRun<LensIndex> lenses;
    lenses.fill(lens);
    RayRun<Candidate> candidates;
    RayRun<bool> found;
    find_candidates(number, film_points, lenses, candidates, found);
    for (int k = 0; k < number; ++k)
        rays[k] = found[k] ? std::optional(complete(candidates[k])) : std::nullopt;
}

/// Rivals of the lens of `c`. The ray `c` itself need not pass the aperture.
inline SheetOptics::Rivals SheetOptics::rivals_of(const Candidate& c) const
{
    constexpr int unknown = 2;
    const double steep = 0.5 * medium_.t * medium_.t; // below this, rounding may exceed the margin
    if (!(c.root * c.root >= steep &&
          dot(c.aperture_point, c.aperture_point) < second_ring_limit_ * second_ring_limit_))
        return {unknown, {}};
    Rivals rivals;
    for (const NeighbourLimit& neighbour : neighbour_limits_) {
        const double component = dot(neighbour.direction, c.aperture_point);
        if (std::fabs(component) < neighbour.limit)
            continue;
        if (++rivals.number == unknown)
            return rivals;
        const Vec2 pole = lattice_.pole(c.lens);
        rivals.lens = lattice_.nearest(component > 0 ? pole - neighbour.to_pole
                                                     : pole + neighbour.to_pole);
    }
    return rivals;
}

/// Sets the result for a film point imaged by `image`, or by no lens (null).
inline void SheetOptics::set(MappedPoint& mapped, const Candidate* image, bool searched) const
{
    if (image)
        mapped.ray.emplace(complete(*image));
    else
        mapped.ray.reset();
    mapped.empty = image ? Empty::none : Empty::outside_aperture;
    mapped.searched = searched;
}

/// Maps a film point, for which is_exact() holds, by `closest` or `automatic` from the ray `c`
/// through the likely lens and, for `automatic`, the ray through one other lens. Returns false if
/// these rays do not determine the result.
inline bool SheetOptics::settle(Vec2 film_point, LensIndex nearest, LensMapping mapping,
                                const Candidate& c, MappedPoint& mapped) const
{
    const bool passing = passes(c.aperture_point), likely_is_nearest = c.lens == nearest;
    if (mapping == LensMapping::automatic && !(passing && likely_is_nearest))
        return settle_between_two(film_point, nearest, c, mapped);
    if (!likely_is_nearest)
        return false;
    set(mapped, passing ? &c : nullptr, false);
    return true;
}

/// settle() by `automatic`, if the likely lens is not the nearest, or its ray misses the aperture.
bool SheetOptics::settle_between_two(Vec2 film_point, LensIndex nearest, const Candidate& c,
                                     MappedPoint& mapped) const
{
    const bool passing = passes(c.aperture_point), likely_is_nearest = c.lens == nearest;
    const Rivals rivals = rivals_of(c);
    if (rivals.number == 0 && (passing || nearest_transmits_)) {
        set(mapped, passing ? &c : nullptr, true);
        return true;
    }
    if (likely_is_nearest && rivals.number != 1)
        return false;

    Candidate second;
    if (!find_candidate(film_point, likely_is_nearest ? rivals.lens : nearest, second))
        return false;
    if (passes(second.aperture_point)) { // the nearest lens, or the only one that can pass
        set(mapped, &second, likely_is_nearest);
        return true;
    }
    const bool only_rival = rivals.number == 1 && second.lens == rivals.lens;
    const bool settled = passing ? only_rival || distance_to_centre(c.aperture_point) < alone_limit_
                                 : only_rival && nearest_transmits_;
    if (settled)
        set(mapped, passing ? &c : nullptr, true);
    return settled;
}

void SheetOptics::restrict_to(const ZonePhase& phase, double margin)
{
    phase_ = phase;
    zone_ = viewing_zone(sheet_, aperture_);
    phase_margin_ = margin;
}

MappedPoint SheetOptics::map(Vec2 film_point, LensMapping mapping) const
{
    MappedPoint mapped = find(film_point, mapping);
    if (phase_)
        keep_phase(mapped);
    return mapped;
}

MappedPoint SheetOptics::find(Vec2 film_point, LensMapping mapping) const
{
    if (!(std::fabs(film_point.x) + std::fabs(film_point.y) <=
          farthest_film * lattice_.pitch())) // also true for NaN
        return {std::nullopt, Empty::outside_aperture, mapping != LensMapping::closest};
    switch (mapping) {
    case LensMapping::closest: return map_closest(film_point);
    case LensMapping::accurate: return map_accurate(film_point);
    case LensMapping::exhaustive: return map_exhaustive(film_point);
    case LensMapping::automatic: break;
    }
    MappedPoint mapped;
    Candidate c;
    if (!neighbour_limits_.empty() && is_exact(film_point) &&
        find_candidate(film_point, lattice_.nearest(likely_pole(film_point)), c) &&
        settle(film_point, lattice_.nearest(film_point), mapping, c, mapped))
        return mapped;
    return map_by_search(film_point);
}

void SheetOptics::map_run(int number, const RayRun<Vec2>& film_points, LensMapping mapping,
                          RayRun<MappedPoint>& mapped) const
{
    const bool closest = mapping == LensMapping::closest;
    if (!closest && (mapping != LensMapping::automatic || neighbour_limits_.empty())) {
        for (int k = 0; k < number; ++k)
            mapped[k] = map(film_points[k], mapping);
        return;
    }
    RayRun<LensIndex> nearest, likely;
    for (int k = 0; k < number; ++k)
        nearest[k] = lattice_.nearest(film_points[k]);
    for (int k = 0; k < number; ++k)
        likely[k] = closest ? nearest[k] : lattice_.nearest(likely_pole(film_points[k]));
    RayRun<Candidate> candidates;
    RayRun<bool> found;
    find_candidates(number, film_points, likely, candidates, found);
    for (int k = 0; k < number; ++k)
        if (!is_exact(film_points[k]))
            mapped[k] = map(film_points[k], mapping);
        else if (!(found[k] &&
                   settle(film_points[k], nearest[k], mapping, candidates[k], mapped[k])))
            mapped[k] = closest ? map_closest(film_points[k]) : map_by_search(film_points[k]);
    for (int k = 0; phase_ && k < number; ++k)
        keep_phase(mapped[k]);
}

MappedPoint SheetOptics::map_closest(Vec2 film_point) const
{
    MappedPoint mapped;
    Candidate c;
    if (!find_candidate(film_point, lattice_.nearest(film_point), c))
        mapped.empty = Empty::total_reflection;
    else if (!passes(c.aperture_point))
        mapped.empty = Empty::outside_aperture;
    else
        mapped.ray.emplace(complete(c));
    return mapped;
}

/// `automatic`, by its definition: `closest`, and `accurate` only if `closest` finds no ray.
MappedPoint SheetOptics::map_by_search(Vec2 film_point) const
{
    MappedPoint mapped = map_closest(film_point);
    if (mapped.ray)
        return mapped;
    const MappedPoint searched = map_accurate(film_point);
    mapped.searched = true;
    if (searched.ray) {
        mapped.ray = searched.ray;
        mapped.empty = Empty::none;
    }
    return mapped;
}

Vec2 mirrored_in_lens(const SheetOptics& optics, Vec2 film_point, LensIndex lens)
{
    const Vec2 offset = optics.lattice().pole(lens) - film_point;
    if (optics.sheet().arrangement != Arrangement::lenticular)
        return film_point + 2 * offset;
    const Vec2 across = optics.lattice().across();
    return film_point + (2 * dot(across, offset)) * across;
}

} // namespace integral
