// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/optics/film_seen.h"

#include <algorithm>

#include "integral/base/vector_loops.h"

namespace integral {

namespace {

/// Pitches from a lens's middle along an axis of the lattice: up to there no other lens can be as
/// near, so that Lattice::nearest does not look for one.
constexpr double surely_nearest = 0.5 - 2e-8;

/// The fields of SheetOptics that the loops need.
struct Lenses {
    explicit Lenses(const SheetOptics& optics)
        : medium(optics.medium()),
          across(optics.lattice().across()),
          along(optics.lattice().along()),
          offset(optics.lattice().pole({0, 0})),
          pitch(optics.lattice().pitch()),
          row_spacing(optics.lattice().row_spacing())
    {
    }
    Medium medium;
    Vec2 across, along, offset;
    double pitch, row_spacing;
};

/// Computes the film points. `beside`: distance of each point from its lens's middle along the axis
/// on which it is greater, in pitches.
template <bool lenticular>
inline __attribute__((always_inline)) void compute(const Lenses lenses, double distance,
                                                   FilmSeenRun& run, double* __restrict beside)
{
    for (int k = 0; k < FilmSeenRun::length; ++k) {
        const Vec2 point{run.x[k], run.y[k]};
        const Vec3 direction{run.eye_x[k] - point.x, run.eye_y[k] - point.y, -distance};
        const Vec2 from_offset = point - lenses.offset;
        const double u = dot(lenses.across, from_offset) / lenses.pitch,
                     column = nearest_integer(u);
        Vec2 base = lenses.offset + (column * lenses.pitch) * lenses.across;
        beside[k] = std::fabs(u - column);
        if constexpr (lenticular) {
            base = point + dot(lenses.across, base - point) * lenses.across;
        } else {
            const double v = dot(lenses.along, from_offset) / lenses.pitch,
                         row = nearest_integer(v);
            base = base + (row * lenses.row_spacing) * lenses.along;
            beside[k] = std::max(beside[k], std::fabs(v - row));
        }
        const Vec2 film = base - offset_from_direction(lenses.medium, direction);
        run.film_x[k] = film.x;
        run.film_y[k] = film.y;
    }
}

INTEGRAL_VECTORS void compute_lenticular(const Lenses& lenses, double distance, FilmSeenRun& run,
                                         double* beside)
{
    compute<true>(lenses, distance, run, beside);
}

INTEGRAL_VECTORS void compute_square(const Lenses& lenses, double distance, FilmSeenRun& run,
                                     double* beside)
{
    compute<false>(lenses, distance, run, beside);
}

} // namespace

void film_points_seen(const SheetOptics& optics, double distance, int number, FilmSeenRun& run)
{
    const auto seen = [&](int k) {
        const Vec2 point{run.x[k], run.y[k]};
        const Vec2 film = optics.film_point_seen(
            point, {run.eye_x[k] - point.x, run.eye_y[k] - point.y, -distance});
        run.film_x[k] = film.x;
        run.film_y[k] = film.y;
    };
    const Arrangement arrangement = optics.lattice().arrangement();
    if (arrangement == Arrangement::hexagonal) {
        for (int k = 0; k < number; ++k)
            seen(k);
        return;
    }
    std::array<double, FilmSeenRun::length> beside;
    (arrangement == Arrangement::lenticular ? compute_lenticular : compute_square)(
        Lenses(optics), distance, run, beside.data());
    for (int k = 0; k < number; ++k)
        if (!(beside[k] <= surely_nearest))
            seen(k);
}

} // namespace integral
