// SPDX-License-Identifier: AGPL-3.0-or-later
// The searches for the lens that images a film point: `accurate` and `exhaustive`.
#include "integral/optics/lens_box.h"
#include "integral/optics/lens_mapping.h"

#include <algorithm>
#include <limits>

namespace integral {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// The greatest radius of a search, in lens pitches. Without it, a search would not end for an
/// unlimited aperture.
constexpr double widest_search = 100;
/// A search radius in lens pitches, within which there are so few lenses that a LensBox saves
/// nothing.
constexpr double few_lenses = 2;

} // namespace

double SheetOptics::aperture_circumradius() const
{
    if (lenticular_)
        return 0.5 * (slit_horizontal_ ? aperture_.width : aperture_.height);
    return 0.5 * std::hypot(aperture_.width, aperture_.height);
}

double SheetOptics::distance_to_centre(Vec2 aperture_point) const
{
    return lenticular_ ? std::fabs(slit_horizontal_ ? aperture_point.x : aperture_point.y)
                       : length(aperture_point);
}

/// The point of the sheet plane through which the film point sees the aperture's centre, to within
/// `error` (mm).
///
/// The image of the centre through a pole at distance P from the axis lies P t/sqrt(n^2 d^2 + m
/// P^2) beyond the pole; |film point| is P plus that. The slope of this sum in P is at least 1, so
/// the residual bounds the error of P. The sum is concave, so Newton's method, started below the
/// solution, stays below it.
Vec2 SheetOptics::pole_seeing_centre(Vec2 film_point, double& error) const
{
    const double radius = length(film_point);
    const double nd = medium_.n * aperture_.distance;
    error = 0;
    if (radius == 0)
        return film_point;
    double p = radius * (nd / (nd + medium_.t));
    for (int step = 0; step < 60; ++step) {
        const double root = std::sqrt(nd * nd + medium_.m * p * p), ratio = nd / root;
        const double missing = radius - p - p * (medium_.t / root);
        error = std::fabs(missing);
        if (error <= 0.02 * lattice_.pitch())
            break;
        p += missing / (1 + (medium_.t / root) * ratio * ratio);
    }
    return (p / radius) * film_point;
}

/// The reason why no lens shows the film point to the aperture. If the nearest lens reflects the
/// point's light totally, all other lenses do, too.
Empty SheetOptics::why_empty(Vec2 film_point) const
{
    return candidate(film_point, lattice_.nearest(film_point)) ? Empty::outside_aperture
                                                               : Empty::total_reflection;
}

/// The lens whose ray passes nearest to the aperture's centre, among the lenses within `radius` of
/// `centre` whose rays pass the aperture. The lattice's rule decides ties.
std::optional<SheetOptics::Candidate> SheetOptics::best_within(Vec2 film_point, Vec2 centre,
                                                               double radius) const
{
    // Lenses whose rays pass are needed twice: for the least distance, then for ties. The first few
    // are stored in between.
    std::array<Candidate, 8> kept;
    std::size_t passing = 0;
    const bool boxed = !lenticular_ && radius > few_lenses * lattice_.pitch();
    const LensBox box = boxed ? box_of_passing_poles(aperture_, medium_, film_point, centre, radius)
                              : LensBox();
    const auto each = [&](auto use) {
        const auto visit = [&](LensIndex lens) {
            Candidate c;
            if (find_candidate(film_point, lens, c) && passes(c.aperture_point))
                use(c, distance_to_centre(c.aperture_point));
        };
        if (boxed)
            for_each_within(lattice_, centre, radius, box, visit);
        else
            lattice_.for_each_within(centre, radius, visit);
    };
    double least = infinity;
    each([&](const Candidate& c, double distance) {
        if (passing < kept.size())
            kept[passing] = c;
        ++passing;
        least = std::min(least, distance);
    });
    std::optional<Candidate> best;
    const auto choose = [&](const Candidate& c, double distance) {
        if (distance <= least + lattice_.tie_tolerance() &&
            (!best || lattice_.preferred(c.lens, best->lens)))
            best = c;
    };
    if (passing > kept.size())
        each(choose);
    else
        for (std::size_t k = 0; k < passing; ++k)
            choose(kept[k], distance_to_centre(kept[k].aperture_point));
    return best;
}

/// The map q -> A from lens offsets to aperture points, A = film point + q g(|q|) with
/// g(r) = 1 + n d/sqrt(t^2 - m r^2), stretches every length by at least the smallest g. A lens
/// whose A is within `reach` of the aperture's centre therefore has its pole within reach/g of
/// pole_seeing_centre(), the point whose A is that centre. The search covers all lenses within this
/// radius (but at most widest_search), and none outside.
MappedPoint SheetOptics::map_accurate(Vec2 film_point) const
{
    MappedPoint mapped;
    mapped.searched = true;
    const double nd = medium_.n * aperture_.distance;
    double slack; // error of the ideal pole and of rounding, mm
    const Vec2 ideal = pole_seeing_centre(film_point, slack);
    slack += 1e-7 * lattice_.pitch() + 1e-8 * length(ideal);
    double reach = aperture_circumradius() * (1 + 1e-8);
    const auto guess = candidate(film_point, lattice_.nearest(ideal));
    const bool guessed = guess && passes(guess->aperture_point);
    if (guessed)
        reach = std::min(reach, distance_to_centre(guess->aperture_point));
    reach += 2 * lattice_.tie_tolerance();

    // Only the nearest lens can be within half a pitch of a point.
    double stretch = 1 + nd / medium_.t;
    if (guessed && reach / stretch + slack < 0.5 * lattice_.pitch()) {
        mapped.ray = complete(*guess);
        return mapped;
    }

    // A better lower bound of g: the least g of the offsets whose aperture point is within `reach`
    // of the aperture's centre.
    const auto stretch_at = [&](double r) {
        const double clear = clearance(medium_, {r, 0});
        return clear > 0 ? 1 + nd / std::sqrt(clear) : infinity;
    };
    const double at_ideal = stretch_at(length(ideal - film_point) + slack);
    const double shortest = (length(film_point) - reach) / at_ideal;
    if (std::isfinite(at_ideal) && shortest > 0)
        stretch = std::max(stretch, stretch_at(shortest * (1 - 1e-9)));
    double radius = reach / stretch + slack;
    if (medium_.m > 0)
        radius = std::min(radius, length(ideal - film_point) + medium_.t / medium_.root_m);
    radius = std::min(radius, widest_search * lattice_.pitch());
    bool alone = guessed;
    if (guessed)
        lattice_.for_each_within(ideal, radius,
                                 [&](LensIndex lens) { alone = alone && lens == guess->lens; });
    if (alone) {
        mapped.ray = complete(*guess);
        return mapped;
    }

    const auto best = best_within(film_point, ideal, radius);
    if (best)
        mapped.ray = complete(*best);
    else
        mapped.empty = why_empty(film_point);
    return mapped;
}

MappedPoint SheetOptics::map_exhaustive(Vec2 film_point) const
{
    // A lens farther from the film point than this cannot send its light through the aperture.
    const double stretch = 1 + medium_.n * aperture_.distance / medium_.t;
    double radius = (aperture_circumradius() * (1 + 1e-8) + length(film_point)) / stretch;
    if (medium_.m > 0)
        radius = std::min(radius, medium_.t / medium_.root_m);
    radius = std::min(radius, 10 * widest_search * lattice_.pitch());
    radius += 1e-7 * lattice_.pitch();

    const auto best = best_within(film_point, film_point, radius);
    MappedPoint mapped;
    mapped.searched = true;
    if (best)
        mapped.ray = complete(*best);
    else
        mapped.empty = why_empty(film_point);
    return mapped;
}

} // namespace integral
