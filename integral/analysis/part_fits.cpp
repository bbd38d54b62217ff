// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/part_fits.h"

#include "integral/analysis/border_slope.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace integral {
namespace {

/// Fit of one part of the film: the distance (pixels) by which it moves the map's middle, and the
/// curvature of the edge strength at that maximum.
struct PartFit {
    int part;   ///< row * parts_side + column
    Vec2 point; ///< its centre, mm
    Vec2 moved;
    double xx = 0, xy = 0, yy = 0; ///< the negative curvature; positive semidefinite
};

constexpr int parts_side = 8;

/// Sets a part's negative curvature to the nearest positive semidefinite one.
void set_curvature(double xx, double xy, double yy, PartFit& fit)
{
    const double middle = 0.5 * (xx + yy), half = std::hypot(0.5 * (xx - yy), xy);
    const double angle = 0.5 * std::atan2(2 * xy, xx - yy), c = std::cos(angle),
                 s = std::sin(angle), first = std::max(0.0, middle + half),
                 second = std::max(0.0, middle - half);
    fit.xx = first * c * c + second * s * s;
    fit.xy = (first - second) * c * s;
    fit.yy = first * s * s + second * c * c;
}

/// The parts with enough borders, each moved from the map to its own maximum by less than
/// `farthest` pixels.
std::vector<PartFit> fit_parts(const Plane& edges, const std::vector<Vec2>& points,
                               const LensSheet& sheet, const ScanMap& map, double farthest)
{
    constexpr std::size_t fewest = 40, most = 1500; // points of a part
    const Squares square(edges, points, map, parts_side);
    std::vector<std::vector<Vec2>> parts(square.count());
    const std::size_t step = std::max<std::size_t>(1, points.size() / (most * parts.size()));
    for (std::size_t k = 0; k < points.size(); k += step)
        if (local(edges, scan_from_film(map, points[k])))
            parts[square(points[k])].push_back(points[k]);
    const std::vector<MapChange> all = free_directions(sheet, map);
    const bool lenticular = sheet.arrangement == Arrangement::lenticular;
    const std::vector<MapChange> free = lenticular ? std::vector<MapChange>{all.back()}
                                                   : std::vector<MapChange>{all[3], all[4]};
    std::vector<PartFit> fits;
    for (int k = 0; k < square.count(); ++k) {
        if (parts[k].size() < fewest)
            continue;
        const ScanMap own = climb(edges, parts[k], map, [&](const ScanMap&) { return free; });
        PartFit fit{k, {}, own.middle - map.middle};
        if (!(length(fit.moved) < farthest))
            continue;
        for (const Vec2 point : parts[k])
            fit.point = fit.point + (1.0 / parts[k].size()) * point;
        const Slope slope = slope_at(edges, parts[k], own, free);
        if (lenticular) {
            const double x = free[0][3], y = free[0][4], d = std::max(0.0, -slope.curvature[0][0]);
            set_curvature(d * x * x, d * x * y, d * y * y, fit);
        } else {
            set_curvature(-slope.curvature[0][0], -slope.curvature[0][1], -slope.curvature[1][1],
                          fit);
        }
        fits.push_back(fit);
    }
    return fits;
}

/// Limits each part's weight to three times the median part's.
void limit_weights(std::vector<PartFit>& fits)
{
    std::vector<double> sizes;
    for (const PartFit& fit : fits)
        sizes.push_back(fit.xx + fit.yy);
    if (sizes.empty())
        return;
    std::nth_element(sizes.begin(), sizes.begin() + sizes.size() / 2, sizes.end());
    const double most = 3 * sizes[sizes.size() / 2];
    for (PartFit& fit : fits) {
        const double factor = fit.xx + fit.yy > most ? most / (fit.xx + fit.yy) : 1;
        fit.xx *= factor;
        fit.xy *= factor;
        fit.yy *= factor;
    }
}

/// A part's contribution to the gradient of the least squares, given `rest`, the part's residual
/// from the common change of the map.
MapChange part_gradient(const PartFit& fit, Vec2 rest, const std::array<Vec2, 5>& motion,
                        std::size_t n)
{
    MapChange gradient{};
    const Vec2 weighed{fit.xx * rest.x + fit.xy * rest.y, fit.xy * rest.x + fit.yy * rest.y};
    for (std::size_t k = 0; k < n; ++k)
        gradient[k] = dot(motion[k], weighed);
    return gradient;
}

/// Index of the group of parts whose errors may be common. `kind`: 0 each part, 1 rows, 2 columns.
int group_of(const PartFit& fit, int kind)
{
    return kind == 0 ? fit.part : kind == 1 ? fit.part / parts_side : fit.part % parts_side;
}

} // namespace

FitErrors errors_of_fit(const Plane& edges, const std::vector<Vec2>& points, const LensSheet& sheet,
                        const ScanMap& map)
{
    const std::vector<MapChange> free = free_directions(sheet, map);
    const std::size_t n = free.size();
    const Lattice lattice(sheet);
    const double farthest = 0.25 * lattice.pitch() * std::max(map.scale.x, map.scale.y);
    std::vector<PartFit> fits = fit_parts(edges, points, sheet, map, farthest);
    limit_weights(fits);
    FitErrors errors;
    for (const Vec2 point : points)
        errors.borders += local(edges, scan_from_film(map, point)).has_value();

    // The common change of the map, by weighted least squares over the parts' own fits.
    const double c = std::cos(map.rotation), s = std::sin(map.rotation);
    Matrix normal{};
    MapChange right{};
    std::vector<std::array<Vec2, 5>> motions;
    for (const PartFit& fit : fits) {
        motions.push_back(motion_of(map, c, s, free, fit.point));
        const auto& m = motions.back();
        const MapChange gradient = part_gradient(fit, fit.moved, m, n);
        for (std::size_t k = 0; k < n; ++k) {
            right[k] += gradient[k];
            const MapChange column = part_gradient(fit, m[k], m, n);
            for (std::size_t l = 0; l < n; ++l)
                normal[k][l] += column[l];
        }
    }
    const auto common = solve(normal, right, n);
    if (!common || fits.size() < 2 * n)
        return errors;

    for (int kind = 0; kind < 3; ++kind) {
        std::map<int, MapChange> groups;
        for (std::size_t f = 0; f < fits.size(); ++f) {
            Vec2 rest = fits[f].moved;
            for (std::size_t k = 0; k < n; ++k)
                rest = rest - (*common)[k] * motions[f][k];
            const MapChange gradient = part_gradient(fits[f], rest, motions[f], n);
            MapChange& group = groups[group_of(fits[f], kind)];
            for (std::size_t k = 0; k < n; ++k)
                group[k] += gradient[k];
        }
        Matrix covariance{};
        const double fitted = kind == 0 ? double(n) : 2; // parameters that groups of this kind fit
        if (groups.size() <= fitted + 1)
            continue;
        for (const auto& [index, gradient] : groups) {
            const auto moved = solve(normal, gradient, n);
            if (!moved)
                return errors;
            for (std::size_t k = 0; k < n; ++k)
                for (std::size_t l = 0; l < n; ++l)
                    covariance[k][l] += (*moved)[k] * (*moved)[l];
        }
        const double correction = groups.size() / (groups.size() - fitted);
        for (int i = 0; i < 5; ++i) {
            double variance = 0;
            for (std::size_t k = 0; k < n; ++k)
                for (std::size_t l = 0; l < n; ++l)
                    variance += free[k][i] * covariance[k][l] * free[l][i];
            errors.deviation[i] = std::max(errors.deviation[i],
                                           std::sqrt(std::max(0.0, correction * variance)));
        }
        errors.across = std::max(errors.across,
                                 std::sqrt(std::max(0.0, correction * covariance[n - 1][n - 1])));
        errors.known = true;
    }
    return errors;
}

namespace {

/// The shift within a cell (scan pixels) at which one part has the strongest edges; nothing if the
/// maximum is within 2 standard deviations of the mean.
std::optional<Vec2> strongest_shift(const Plane& edges, const std::vector<Vec2>& points,
                                    const LensSheet& sheet, const ScanMap& map)
{
    const Lattice lattice(sheet);
    const bool lenticular = sheet.arrangement == Arrangement::lenticular;
    const double pixels = std::max(map.scale.x, map.scale.y);
    const int columns = std::max(4, int(lattice.pitch() * pixels)),
              rows = lenticular ? 1 : std::max(4, int(lattice.row_spacing() * pixels));
    const std::size_t count = std::min<std::size_t>(points.size(), 600);
    double sum = 0, squares = 0, most = -1e30;
    Vec2 best;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const double u = (i + 0.5 * (columns % 2)) / columns - 0.5,
                         v = lenticular ? 0 : (j + 0.5 * (rows % 2)) / rows - 0.5;
            const Vec2 shift = (u * lattice.pitch()) * lattice.across() +
                               (v * lattice.row_spacing()) * lattice.along();
            const Vec2 by = scan_from_film(map, shift) - map.middle;
            double edge = 0;
            for (std::size_t k = 0; k < count; ++k) {
                const Vec2 pixel = scan_from_film(map, points[k * points.size() / count]) + by;
                const int x = int(std::floor(pixel.x)), y = int(std::floor(pixel.y));
                if (x >= 0 && y >= 0 && x < edges.width && y < edges.height)
                    edge += edges.at(x, y) - edges.mean;
            }
            sum += edge;
            squares += edge * edge;
            if (edge > most) {
                most = edge;
                best = by;
            }
        }
    const double number = double(rows) * columns, mean = sum / number,
                 deviation = std::sqrt(std::max(0.0, squares / number - mean * mean));
    if (!(most - mean > 2 * deviation))
        return std::nullopt;
    return best;
}

} // namespace

LeftOutParts check_left_out_parts(const Plane& edges, const std::vector<Vec2>& points,
                                  const LensSheet& sheet, const ScanMap& map)
{
    constexpr double lenses_off = 1.0 / 7; // parts that agree are closer
    const Squares square(edges, points, map, parts_side);
    const double pixels = sheet.pitch * std::max(map.scale.x, map.scale.y);
    LeftOutParts result;
    for (int parity = 0; parity < 2; ++parity) {
        std::vector<Vec2> others;
        std::vector<std::vector<Vec2>> parts(square.count());
        for (const Vec2 point : points) {
            if (!local(edges, scan_from_film(map, point)))
                continue;
            const int part = square(point);
            if ((part / parts_side + part % parts_side) % 2 == parity)
                parts[part].push_back(point);
            else
                others.push_back(point);
        }
        const ScanMap by_others = fit_borders(edges, others, sheet, map);
        for (const auto& part : parts) {
            if (part.size() < 40)
                continue;
            const auto shift = strongest_shift(edges, part, sheet, by_others);
            result.parts += shift.has_value();
            result.agreeing += shift && length(*shift) < lenses_off * pixels;
        }
    }
    return result;
}

} // namespace integral
