// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/sheet_view.h"

#include "integral/analysis/least_squares.h"
#include "integral/base/constants.h"
#include "integral/optics/lens_surface.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace integral {
namespace {

SlopePolynomial terms_at(double u, double v)
{
    const double u2 = u * u, v2 = v * v;
    return {1, u2, v2, u2 * u2, u2 * v2, v2 * v2};
}

double value_at(const SlopePolynomial& polynomial, const SlopePolynomial& terms)
{
    double sum = 0;
    for (std::size_t k = 0; k < terms.size(); ++k)
        sum += polynomial[k] * terms[k];
    return sum;
}

/// Displacement on the film of what a ray shows, mm, from where it passes the plane of the poles:
/// of the beat bands' phase, and of coarse light.
struct Displacement {
    Vec2 beat, coarse;
};

Displacement displacement_of(const SheetView& view, Vec3 direction)
{
    const Vec2 across{std::cos(view.angle), std::sin(view.angle)}, along{-across.y, across.x},
        lateral{direction.x, direction.y};
    const double du = dot(across, lateral), dv = dot(along, lateral), u = du / -direction.z,
                 v = dv / -direction.z,
                 by_pole = view.thickness / std::sqrt(view.ior * view.ior - du * du - dv * dv);
    const SlopePolynomial terms = terms_at(u, v);
    const double share = view.surface_share,
                 beat = by_pole * du * (1 + share * value_at(view.surface.beat, terms)),
                 coarse = beat +
                          share * view.thickness_share * u * value_at(view.surface.coarse, terms);
    const Vec2 both = by_pole * dv * (1 + share * value_at(view.surface.along, terms)) * along;
    return {both + beat * across, both + coarse * across};
}

/// The film that a lens shows to rays with one pair of slopes, by tracing them to its surface.
struct TracedFilm {
    double beat, coarse, along; ///< displacements across the lenses, and along them, mm
};

std::optional<TracedFilm> trace(const SheetSurface& surface, double pitch, Vec2 slope)
{
    constexpr int points = 2000; // one more or less behind a lens counts as a whole pitch
    std::complex<double> beat;
    TracedFilm traced{0, 0, 0};
    for (int k = 0; k < points; ++k) {
        const double at = (k + 0.5) / points * pitch;
        const auto met = surface.first_intersection({at, 0}, slope);
        const auto film = surface.film_point_seen({at, 0}, slope, 0);
        if (!met || !film)
            return std::nullopt;
        const double axis = at + met->depth * slope.x - met->offset.x;
        beat += std::polar(1.0, 2 * pi * (film->x - axis) / pitch);
        traced.coarse += (film->x - at) / points;
        traced.along += film->y / points;
    }
    traced.beat = std::arg(beat) / (2 * pi) * pitch;
    return traced;
}

} // namespace

SurfaceEffect surface_effect(const LensSheet& sheet)
{
    constexpr int steps = 6;
    constexpr double steepest = 0.6;
    if (!has_surface(sheet))
        return {};
    LensSheet upright = sheet;
    upright.slant = 0;
    upright.offset = {};
    const SheetSurface surface(upright);
    const Medium medium(sheet.thickness, sheet.ior);
    SquareMatrix normal(6);
    std::vector<double> right[3] = {std::vector<double>(6), std::vector<double>(6),
                                    std::vector<double>(6)};
    for (int i = 1; i <= steps; ++i)
        for (int j = 1; j <= steps; ++j) {
            const Vec2 slope{steepest * i / steps, steepest * j / steps};
            const auto traced = trace(surface, sheet.pitch, slope);
            if (!traced)
                return {};
            const Vec2 by_pole = offset_from_direction(medium, {slope.x, slope.y, -1});
            // The phase is known but for whole pitches.
            const double beat = traced->beat +
                                sheet.pitch * std::round((by_pole.x - traced->beat) / sheet.pitch),
                         values[] = {beat / by_pole.x - 1, (traced->coarse - beat) / slope.x,
                                     traced->along / by_pole.y - 1};
            const SlopePolynomial terms = terms_at(slope.x, slope.y);
            for (std::size_t k = 0; k < 6; ++k) {
                for (int of = 0; of < 3; ++of)
                    right[of][k] += terms[k] * values[of];
                for (std::size_t l = 0; l < 6; ++l)
                    normal.at(k, l) += terms[k] * terms[l];
            }
        }
    SurfaceEffect effect;
    SlopePolynomial* const polynomials[] = {&effect.beat, &effect.coarse, &effect.along};
    for (int of = 0; of < 3; ++of) {
        const auto solved = solve_positive(normal, right[of]);
        if (!solved)
            return {};
        std::copy(solved->begin(), solved->end(), polynomials[of]->begin());
    }
    return effect;
}

Sight sight_of(const SheetView& view, Vec2 photo)
{
    const Vec3 direction = direction_from_photo(view.camera, photo);
    const double way = (view.thickness - view.camera.place.z) / direction.z;
    const Vec3 at = view.camera.place + way * direction;
    const Displacement displacement = displacement_of(view, direction);
    const auto printed = [&](Vec2 by) {
        return Vec2{at.x + by.x, (at.y + by.y) / (1 + view.stretch)};
    };
    return {{at.x, at.y}, printed(displacement.beat), printed(displacement.coarse)};
}

Vec2 photo_of_film(const SheetView& view, Vec2 film)
{
    film.y *= 1 + view.stretch;
    Vec2 lens = film;
    for (int k = 0; k < 4; ++k) {
        const Vec3 from = Vec3{lens.x, lens.y, view.thickness} - view.camera.place;
        lens = film - displacement_of(view, (1 / length(from)) * from).coarse;
    }
    return photo_from_page(view.camera, {lens.x, lens.y, view.thickness});
}

double band_phase(const SheetView& view, const CalibrationBand& band, const Sight& sight)
{
    if (band.kind != BandKind::beat && band.kind != BandKind::leak)
        return dot(band.wave, sight.coarse_film) / band.period;
    const Vec2 across{std::cos(view.angle), std::sin(view.angle)};
    return dot(band.wave, sight.film) / band.period -
           (dot(across, sight.lens) - view.phase) / view.pitch;
}

} // namespace integral
