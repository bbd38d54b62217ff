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

/// Computes the same for hexagonal lenses: every second row is shifted by half a pitch. The nearest
/// pole is in one of the two rows that enclose the point. `beside` is 1 where both are about as
/// near.
INTEGRAL_VECTORS void compute_hexagonal(const Lenses& given, double distance, FilmSeenRun& run,
                                        double* __restrict beside)
{
    const Lenses lenses = given; // the compiler must know that stores cannot change it
    const double close = 2e-8 * lenses.pitch * lenses.pitch;
    for (int k = 0; k < FilmSeenRun::length; ++k) {
        const Vec2 point{run.x[k], run.y[k]};
        const Vec3 direction{run.eye_x[k] - point.x, run.eye_y[k] - point.y, -distance};
        const Vec2 from_offset = point - lenses.offset;
        const double x = dot(lenses.across, from_offset), y = dot(lenses.along, from_offset),
                     row = y / lenses.row_spacing, near = nearest_integer(row),
                     lower = near > row ? near - 1 : near, upper = lower + 1;
        // 0 or 1/2: j - 2 floor(j/2) is 1 for odd rows.
        const double lower_shift = 0.5 * (lower - 2 * nearest_integer(0.5 * lower - 0.25)),
                     upper_shift = 0.5 - lower_shift;
        const double lower_u = x / lenses.pitch - lower_shift,
                     upper_u = x / lenses.pitch - upper_shift,
                     lower_column = nearest_integer(lower_u),
                     upper_column = nearest_integer(upper_u);
        const Vec2 to_lower{x - (lower_column + lower_shift) * lenses.pitch,
                            y - lower * lenses.row_spacing},
            to_upper{x - (upper_column + upper_shift) * lenses.pitch,
                     y - upper * lenses.row_spacing};
        const double difference = dot(to_lower, to_lower) - dot(to_upper, to_upper);
        const double column = difference <= 0 ? lower_column + lower_shift
                                              : upper_column + upper_shift,
                     nearest_row = difference <= 0 ? lower : upper;
        const double farther = std::max(std::fabs(lower_u - lower_column),
                                        std::fabs(upper_u - upper_column));
        beside[k] = std::fabs(difference) <= close ? 1 : farther;
        const Vec2 pole = lenses.offset + (column * lenses.pitch) * lenses.across +
                          (nearest_row * lenses.row_spacing) * lenses.along;
        const Vec2 film = pole - offset_from_direction(lenses.medium, direction);
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
    std::array<double, FilmSeenRun::length> beside;
    const auto compute_all = arrangement == Arrangement::lenticular ? compute_lenticular
                             : arrangement == Arrangement::square   ? compute_square
                                                                    : compute_hexagonal;
    compute_all(Lenses(optics), distance, run, beside.data());
    for (int k = 0; k < number; ++k)
        if (!(beside[k] <= surely_nearest))
            seen(k);
}

} // namespace integral
