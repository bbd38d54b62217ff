// SPDX-License-Identifier: AGPL-3.0-or-later
// The lens models of optics.md section 3, forward and inverse, in 100-digit arithmetic: Snell's law
// with vectors in space, and roots found by bracketing. Shares nothing with integral/optics but the
// parameter structs.
#ifndef TESTS_UNIT_OPTICS_BEAM_ORACLE_H
#define TESTS_UNIT_OPTICS_BEAM_ORACLE_H

#include "tests/unit/optics_oracle.h"

namespace oracle {

struct Vector {
    Real x, y, z;
};

inline Vector operator+(const Vector& a, const Vector& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector operator-(const Vector& a, const Vector& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector operator*(const Real& s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Real dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Real length(const Vector& a) { return sqrt(dot(a, a)); }
inline Vector cross(const Vector& a, const Vector& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// One ray of a film point's light outside the lens. For the error bound it also has the cosines of
/// incidence and refraction at the surface, and the path's length inside the lens.
struct Beam {
    Vector point, direction;
    Point aperture;
    Real cos_inside, cos_outside, length;
    Vector film;
};

/// The system whose beams are computed. ior() is 1 for the pinhole.
struct System {
    integral::LensSheet sheet;
    integral::LensModel model;
    double distance;
    Real ior() const { return model == integral::LensModel::pinhole ? Real(1) : Real(sheet.ior); }
    bool curved() const
    {
        return model == integral::LensModel::hybrid || model == integral::LensModel::full;
    }
    bool lenticular() const { return sheet.arrangement == integral::Arrangement::lenticular; }
};

/// A point of the surface with its outward normal (towards the viewer), and the lens's frame there.
struct Surface {
    Vector point, normal; ///< lenticular: any point of the generating line
    Vector along;         ///< lenticular: the line's direction
    Vector shift;         ///< the ideal beam's parallel displacement, otherwise 0
};

inline std::optional<Surface> surface(const System& system, integral::LensIndex lens,
                                      const integral::LensPoint& at)
{
    Point b, a;
    axes(system.sheet, b, a);
    const Point centre = pole(system.sheet, lens);
    Point offset{at.offset.x, at.offset.y};
    Surface out;
    out.along = {a.x, a.y, 0};
    if (!system.curved()) {
        out.shift = {offset.x, offset.y, 0};
        out.point = {centre.x, centre.y, 0};
        out.normal = {0, 0, -1};
        return out;
    }
    if (system.lenticular()) {
        const Real v = offset.x * b.x + offset.y * b.y;
        offset = {v * b.x, v * b.y};
    }
    const Real n = system.ior(), radius = Real(system.sheet.thickness) * (n - 1) / n;
    const Real inside = radius * radius - offset.x * offset.x - offset.y * offset.y;
    if (inside < 0)
        return std::nullopt;
    out.point = {centre.x + offset.x, centre.y + offset.y, radius - sqrt(inside)};
    const Vector middle{centre.x, centre.y, radius};
    out.normal = (1 / radius) * (out.point - middle);
    return out;
}

/// The refracted ray of light that goes from `film` to the surface; nothing on total reflection,
/// from the outer side, or away from the viewer.
inline std::optional<Beam> refract(const System& system, const Vector& film, const Vector& point,
                                   const Vector& normal)
{
    const Real n = system.ior();
    Beam beam;
    beam.film = film;
    beam.point = point;
    beam.length = length(point - film);
    const Vector inside = (1 / beam.length) * (point - film);
    beam.cos_inside = dot(inside, normal);
    const Real cos2 = 1 - n * n * (1 - beam.cos_inside * beam.cos_inside);
    if (beam.cos_inside <= 0 || cos2 <= 0)
        return std::nullopt;
    beam.cos_outside = sqrt(cos2);
    beam.direction = n * inside + (beam.cos_outside - n * beam.cos_inside) * normal;
    if (beam.direction.z >= 0)
        return std::nullopt;
    const Real way = (system.distance + point.z) / -beam.direction.z;
    beam.aperture = {point.x + way * beam.direction.x, point.y + way * beam.direction.y};
    return beam;
}

using Tolerance = bool (*)(const Real&, const Real&);
inline bool to_80_digits(const Real& a, const Real& b)
{
    const Real size = (std::max)(abs(a), abs(b));
    return abs(a - b) <= size * Real("1e-80") || size < Real("1e-120");
}

template <class Function>
Real root_between(const Function& function, const Real& low, const Real& high)
{
    const Real at_low = function(low), at_high = function(high);
    if (at_low == 0 || at_high == 0)
        return at_low == 0 ? low : high;
    boost::uintmax_t most = 400;
    const Tolerance tolerance = to_80_digits;
    const auto found = boost::math::tools::toms748_solve(function, low, high, at_low, at_high,
                                                         tolerance, most);
    return (found.first + found.second) / 2;
}

/// Finds light from a film point through a generating line of a cylinder and through the slit. For
/// a point of the line, take the distance from the slit to where its light meets the slit's plane,
/// times the cosine there. This has opposite signs at both ends of the part of the line from which
/// light can leave towards the viewer.
class ThroughSlit {
public:
    ThroughSlit(const System& system, const Vector& film, const Surface& line, double height)
        : system_(system),
          line_(line),
          slit_(slit_frame(system.sheet, {line.along.x, line.along.y}, height)),
          n_(system.ior()),
          foot_(line.point + dot(film - line.point, line.along) * line.along),
          to_foot_(foot_ - film),
          normal_way_(dot(to_foot_, line.normal))
    {
    }

    /// Half the length of line from which light can leave, if the sign changes there.
    std::optional<Real> end() const
    {
        // total reflection: n^2 (L^2 - (D.N)^2) = L^2
        const Real room = normal_way_ * normal_way_ * n_ * n_ -
                          dot(to_foot_, to_foot_) * (n_ * n_ - 1);
        const auto towards_viewer = [&](const Real& tau) { return Real(-refracted(tau).z); };
        if (normal_way_ <= 0 || room <= 0 || towards_viewer(0) <= 0)
            return std::nullopt;
        Real end = sqrt(room / (n_ * n_ - 1));
        if (towards_viewer(end) < 0)
            end = root_between(towards_viewer, 0, end);
        if (beside_slit(-end) >= 0 || beside_slit(end) <= 0)
            return std::nullopt;
        return end;
    }

    std::optional<Vector> point() const
    {
        const auto limit = end();
        if (!limit)
            return std::nullopt;
        return foot_ +
               root_between([&](const Real& tau) { return beside_slit(tau); }, -*limit, *limit) *
                   line_.along;
    }

private:
    Vector refracted(const Real& tau) const
    {
        const Vector way = to_foot_ + tau * line_.along;
        const Real reach = length(way), cos_inside = normal_way_ / reach;
        const Real cos2 = 1 - n_ * n_ * (1 - cos_inside * cos_inside);
        return (n_ / reach) * way +
               ((cos2 > 0 ? Real(sqrt(cos2)) : Real(0)) - n_ * cos_inside) * line_.normal;
    }
    Real beside_slit(const Real& tau) const
    {
        const Vector out = refracted(tau), at = foot_ + tau * line_.along;
        const auto& [e, eta] = slit_;
        return (e.x * at.x + e.y * at.y - eta) * -out.z +
               (system_.distance + at.z) * (e.x * out.x + e.y * out.y);
    }

    const System& system_;
    const Surface& line_;
    SlitFrame slit_;
    Real n_;
    Vector foot_, to_foot_;
    Real normal_way_;
};

/// The oracle of beam_ray.
inline std::optional<Beam> beam(const System& system, integral::Vec2 film_point,
                                integral::LensIndex lens, const integral::LensPoint& at)
{
    const auto where = surface(system, lens, at);
    if (!where)
        return std::nullopt;
    const Vector film{film_point.x, film_point.y, system.sheet.thickness};
    std::optional<Beam> out;
    if (!system.lenticular())
        out = refract(system, film, where->point, where->normal);
    else if (system.curved()) {
        if (const auto point = ThroughSlit(system, film, *where, at.slit).point())
            out = refract(system, film, *point, where->normal);
    } else {
        integral::LensSheet sheet = system.sheet;
        if (system.model == integral::LensModel::pinhole)
            sheet.ior = 1;
        const auto pole_ray = ray(sheet, system.distance, film_point, lens, at.slit);
        if (pole_ray)
            out = refract(system, film, {pole_ray->pole.x, pole_ray->pole.y, 0}, where->normal);
    }
    if (!out)
        return out;
    out->point = out->point + where->shift;
    out->aperture = {out->aperture.x + where->shift.x, out->aperture.y + where->shift.y};
    return out;
}

/// The oracle of film_point_imaging: `from` is where the light leaves the lens, `film` where it
/// comes from.
struct Inverse {
    Vector from;
    Point film;
    Real length, depth;
};

inline std::optional<Inverse> imaging(const System& system, const Vector& scene,
                                      integral::LensIndex lens, const integral::LensPoint& at)
{
    const auto where = surface(system, lens, at);
    if (!where)
        return std::nullopt;
    Inverse out;
    out.from = where->point + where->shift;
    Vector line = scene - out.from;
    if (system.lenticular()) {
        // The plane through the generating line and the scene point cuts the slit in one point.
        auto [e, eta] = slit_frame(system.sheet, {where->along.x, where->along.y}, at.slit);
        eta += e.x * where->shift.x + e.y * where->shift.y;
        const Vector plane = cross(where->along, line), slit{-e.y, e.x, 0};
        const Vector start{eta * e.x, eta * e.y, -Real(system.distance)};
        const Real slope = dot(plane, slit);
        if (slope == 0)
            return std::nullopt;
        const Vector aperture = start + (dot(plane, out.from - start) / slope) * slit;
        if (scene.z == aperture.z)
            return std::nullopt;
        line = scene - aperture;
        out.from = aperture + ((out.from.z - aperture.z) / line.z) * line;
    }
    if (line.z == 0)
        return std::nullopt;
    const Vector direction = ((line.z > 0 ? -1 : 1) / length(line)) * line;
    const Real n = system.ior(), normal = dot(direction, where->normal);
    if (normal <= 0)
        return std::nullopt;
    const Vector tangential = (1 / n) * (direction - normal * where->normal);
    const Vector inside = tangential + sqrt(1 - dot(tangential, tangential)) * where->normal;
    out.depth = system.sheet.thickness - out.from.z;
    out.length = out.depth / -inside.z;
    const Vector film = out.from - where->shift - out.length * inside;
    out.film = {film.x, film.y};
    // Where there are two ways from a film point to the slit, there is no ray.
    const bool refracted = system.lenticular() && n > 1;
    if (refracted && !ThroughSlit(system, film, *where, at.slit).end())
        return std::nullopt;
    return out;
}

} // namespace oracle

#endif
