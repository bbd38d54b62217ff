// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/border_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace integral {
namespace {

/// A plane's value between its pixels' centres, with its slopes and curvatures, which are
/// differences over one pixel.
struct Local {
    double value, x, y, xx, xy, yy;
};

/// Nothing within two pixels of the plane's edge.
std::optional<Local> local(const Plane& plane, Vec2 pixel)
{
    const double x = pixel.x - 0.5, y = pixel.y - 0.5;
    if (!(x >= 2 && y >= 2 && std::floor(x) + 3 < plane.width &&
          std::floor(y) + 3 < plane.height)) // the search may step far outside
        return std::nullopt;
    const int left = int(std::floor(x)), top = int(std::floor(y));
    const double u = x - left, v = y - top;
    double s[3][3]; // a pixel apart, the place itself in the middle
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) {
            const int column = left + i - 1, row = top + j - 1;
            s[j][i] = (1 - v) * ((1 - u) * plane.at(column, row) + u * plane.at(column + 1, row)) +
                      v * ((1 - u) * plane.at(column, row + 1) + u * plane.at(column + 1, row + 1));
        }
    return Local{s[1][1],
                 0.5 * (s[1][2] - s[1][0]),
                 0.5 * (s[2][1] - s[0][1]),
                 s[1][2] - 2 * s[1][1] + s[1][0],
                 0.25 * (s[2][2] - s[2][0] - s[0][2] + s[0][0]),
                 s[2][1] - 2 * s[1][1] + s[0][1]};
}

/// How a point's place in the scan moves (pixels along x and y) with each free direction. c and s
/// are the cosine and sine of the map's rotation.
std::array<Vec2, 5> motion_of(const ScanMap& map, double c, double s,
                              const std::vector<MapChange>& free, Vec2 point)
{
    const Vec2 r{c * point.x - s * point.y, s * point.x + c * point.y};
    std::array<Vec2, 5> motion;
    for (std::size_t k = 0; k < free.size(); ++k) {
        const MapChange& f = free[k];
        motion[k] = {f[0] * map.scale.x * r.x - f[2] * map.scale.x * r.y + f[3],
                     -f[1] * map.scale.y * r.y - f[2] * map.scale.y * r.x + f[4]};
    }
    return motion;
}

using Matrix = std::array<std::array<double, 5>, 5>;

/// A sum over points, with its first and second derivatives along the free directions.
struct Slope {
    double value = 0;
    MapChange gradient{};
    Matrix curvature{};
};

/// Of the edge at the points.
Slope slope_at(const Plane& edges, const std::vector<Vec2>& points, const ScanMap& map,
               const std::vector<MapChange>& free)
{
    const double c = std::cos(map.rotation), s = std::sin(map.rotation);
    Slope slope;
    for (const Vec2 point : points) {
        const auto edge = local(edges, scan_from_film(map, point));
        if (!edge)
            continue;
        slope.value += edge->value - edges.mean;
        const auto motion = motion_of(map, c, s, free, point);
        for (std::size_t k = 0; k < free.size(); ++k) {
            slope.gradient[k] += edge->x * motion[k].x + edge->y * motion[k].y;
            for (std::size_t l = 0; l <= k; ++l)
                slope.curvature[k][l] += motion[k].x *
                                             (edge->xx * motion[l].x + edge->xy * motion[l].y) +
                                         motion[k].y *
                                             (edge->xy * motion[l].x + edge->yy * motion[l].y);
        }
    }
    for (std::size_t k = 0; k < free.size(); ++k)
        for (std::size_t l = 0; l < k; ++l)
            slope.curvature[l][k] = slope.curvature[k][l];
    return slope;
}

/// Solves a x = b for a symmetric positive definite a of `n` rows; nothing if it is not.
std::optional<MapChange> solve(Matrix a, MapChange b, std::size_t n)
{
    for (std::size_t k = 0; k < n; ++k) { // Cholesky
        for (std::size_t l = 0; l <= k; ++l) {
            double sum = a[k][l];
            for (std::size_t i = 0; i < l; ++i)
                sum -= a[k][i] * a[l][i];
            if (k == l && !(sum > 0))
                return std::nullopt;
            a[k][l] = k == l ? std::sqrt(sum) : sum / a[l][l];
        }
    }
    for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t i = 0; i < k; ++i)
            b[k] -= a[k][i] * b[i];
        b[k] /= a[k][k];
    }
    for (std::size_t k = n; k-- > 0;) {
        for (std::size_t i = k + 1; i < n; ++i)
            b[k] -= a[i][k] * b[i];
        b[k] /= a[k][k];
    }
    return b;
}

MapChange combined(const std::vector<MapChange>& free, const MapChange& amounts)
{
    MapChange change{};
    for (std::size_t k = 0; k < free.size(); ++k)
        for (int i = 0; i < 5; ++i)
            change[i] += amounts[k] * free[k][i];
    return change;
}

} // namespace

std::vector<MapChange> free_directions(const LensSheet& sheet, const ScanMap& map)
{
    if (sheet.arrangement != Arrangement::lenticular)
        return {
            {1, 0, 0, 0, 0}, {0, 1, 0, 0, 0}, {0, 0, 1, 0, 0}, {0, 0, 0, 1, 0}, {0, 0, 0, 0, 1}};
    // Across the lenses' lines in the scan: the direction b across the sheet's lenses, turned, and
    // divided by the scales as normals are.
    const Vec2 b = Lattice(sheet).across();
    const double c = std::cos(map.rotation), s = std::sin(map.rotation);
    const Vec2 normal{(c * b.x - s * b.y) / map.scale.x, -(s * b.x + c * b.y) / map.scale.y};
    const Vec2 across = (1 / length(normal)) * normal;
    return {{1, 1, 0, 0, 0}, {0, 0, 1, 0, 0}, {0, 0, 0, across.x, across.y}};
}

ScanMap changed(const ScanMap& map, const MapChange& change)
{
    return {{map.middle.x + change[3], map.middle.y + change[4]},
            {map.scale.x * std::exp(change[0]), map.scale.y * std::exp(change[1])},
            map.rotation + change[2]};
}

double edge_on_borders(const Plane& edges, const std::vector<Vec2>& points, const ScanMap& map)
{
    double sum = 0;
    for (const Vec2 point : points) {
        const Vec2 pixel = scan_from_film(map, point);
        const int x = int(std::floor(pixel.x)),
                  y = int(std::floor(pixel.y)); // the nearest pixel, as the plane is blurred
        if (x >= 0 && y >= 0 && x < edges.width && y < edges.height)
            sum += edges.at(x, y) - edges.mean;
    }
    return sum / std::max<std::size_t>(1, points.size());
}

namespace {

/// The next step of a damped Newton search for the maximum; nothing if the damping is too weak for
/// the curvature.
std::optional<MapChange> newton_step(const Slope& here, const std::vector<MapChange>& free,
                                     double damping)
{
    Matrix downwards = here.curvature;
    for (std::size_t k = 0; k < free.size(); ++k) {
        for (std::size_t l = 0; l < free.size(); ++l)
            downwards[k][l] = -downwards[k][l];
        downwards[k][k] += damping * std::fabs(downwards[k][k]);
    }
    const auto amounts = solve(downwards, here.gradient, free.size());
    if (!amounts)
        return std::nullopt;
    return combined(free, *amounts);
}

} // namespace

ScanMap fit_borders(const Plane& edges, const std::vector<Vec2>& points, const LensSheet& sheet,
                    ScanMap map)
{
    double farthest = 0;
    for (const Vec2 point : points)
        farthest = std::max(farthest, length(point));
    const double reach = farthest * std::max(map.scale.x, map.scale.y);
    double damping = 1e-3;
    std::vector<MapChange> free = free_directions(sheet, map);
    Slope here = slope_at(edges, points, map, free);
    for (int step = 0; step < 40 && damping < 1e8; ++step) {
        const auto change = newton_step(here, free, damping);
        if (!change) {
            damping = std::max(1e-2, 10 * damping);
            continue;
        }
        const auto& c = *change;
        const double moved = reach * (std::fabs(c[0]) + std::fabs(c[1]) + std::fabs(c[2])) +
                             std::fabs(c[3]) + std::fabs(c[4]);
        const ScanMap there = changed(map, c);
        const std::vector<MapChange> free_there = free_directions(sheet, there);
        const Slope next = slope_at(edges, points, there, free_there);
        if (next.value >= here.value) {
            map = there;
            here = next;
            free = free_there;
            damping *= 0.1;
        } else {
            damping = std::max(1e-3, 10 * damping);
        }
        if (moved < 1e-4)
            break;
    }
    return map;
}

namespace {

/// Divides the film that the scan holds into `side` x `side` parts and tells in which a point lies.
class Squares {
public:
    Squares(const Plane& edges, const std::vector<Vec2>& points, const ScanMap& map, int side)
        : side_(side)
    {
        for (const Vec2 point : points) {
            if (!local(edges, scan_from_film(map, point)))
                continue;
            least_ = {std::min(least_.x, point.x), std::min(least_.y, point.y)};
            most_ = {std::max(most_.x, point.x), std::max(most_.y, point.y)};
        }
    }
    int count() const { return side_ * side_; }
    int operator()(Vec2 point) const
    {
        return index(point.y, least_.y, most_.y) * side_ + index(point.x, least_.x, most_.x);
    }

private:
    int index(double at, double from, double to) const
    {
        return std::clamp(int(side_ * (at - from) / std::max(1e-30, to - from)), 0, side_ - 1);
    }
    int side_;
    Vec2 least_{1e30, 1e30}, most_{-1e30, -1e30};
};

/// Shifts (mm) that are evenly spread over a cell of the lattice, by Roberts's sequence.
std::vector<Vec2> shifts_in_cell(const LensSheet& sheet, int count)
{
    const Lattice lattice(sheet);
    std::vector<Vec2> shifts;
    for (int k = 1; k <= count; ++k) {
        const double u = std::fmod(0.5 + k * 0.75487766624669276, 1),
                     v = std::fmod(0.5 + k * 0.56984029099805327, 1);
        shifts.push_back((u * lattice.pitch()) * lattice.across() +
                         (v * lattice.row_spacing()) * lattice.along());
    }
    return shifts;
}

} // namespace

std::vector<Vec2> where_borders_show(const Plane& edges, const std::vector<Vec2>& points,
                                     const LensSheet& sheet, const ScanMap& map)
{
    constexpr int side = 16;
    constexpr double least_share = 0.3; // of the contrast that a tenth of the squares exceeds
    const Squares square(edges, points, map, side);
    const std::vector<Vec2> shifts = shifts_in_cell(sheet, 6);
    struct Sum {
        double on = 0, elsewhere = 0, count = 0, count_elsewhere = 0;
        double contrast() const
        {
            return count > 0 && count_elsewhere > 0 ? on / count - elsewhere / count_elsewhere : 0;
        }
    };
    std::vector<Sum> sums(square.count());
    std::size_t next = 0;
    for (const Vec2 point : points) {
        Sum& sum = sums[square(point)];
        if (const auto edge = local(edges, scan_from_film(map, point))) {
            sum.on += edge->value;
            ++sum.count;
        }
        if (const auto edge = local(edges,
                                    scan_from_film(map, point + shifts[next++ % shifts.size()]))) {
            sum.elsewhere += edge->value;
            ++sum.count_elsewhere;
        }
    }
    std::vector<double> contrasts;
    for (const Sum& sum : sums)
        contrasts.push_back(sum.contrast());
    std::sort(contrasts.begin(), contrasts.end());
    const double least = least_share * contrasts[contrasts.size() * 9 / 10];
    std::vector<Vec2> kept;
    for (const Vec2 point : points)
        if (sums[square(point)].contrast() > least)
            kept.push_back(point);
    return kept;
}

namespace {

/// The gradients of the parts of the film (8 x 8); counts the points that lie in the scan.
std::vector<MapChange> gradients_of_parts(const Plane& edges, const std::vector<Vec2>& points,
                                          const ScanMap& map, const std::vector<MapChange>& free,
                                          int& counted)
{
    constexpr int side = 8;
    const double c = std::cos(map.rotation), s = std::sin(map.rotation);
    const Squares square(edges, points, map, side);
    std::vector<MapChange> gradients(square.count(), MapChange{});
    for (const Vec2 point : points) {
        const auto edge = local(edges, scan_from_film(map, point));
        if (!edge)
            continue;
        const auto motion = motion_of(map, c, s, free, point);
        MapChange& gradient = gradients[square(point)];
        for (std::size_t k = 0; k < free.size(); ++k)
            gradient[k] += edge->x * motion[k].x + edge->y * motion[k].y;
        ++counted;
    }
    return gradients;
}

} // namespace

FitErrors errors_of_fit(const Plane& edges, const std::vector<Vec2>& points, const LensSheet& sheet,
                        const ScanMap& map)
{
    const std::vector<MapChange> free = free_directions(sheet, map);
    const std::size_t n = free.size();
    FitErrors errors;
    const auto gradients = gradients_of_parts(edges, points, map, free, errors.borders);
    Matrix downwards = slope_at(edges, points, map, free).curvature;
    for (auto& row : downwards)
        for (double& value : row)
            value = -value;
    Matrix covariance{};
    double used = 0; // parts
    for (const MapChange& gradient : gradients) {
        const auto moved = solve(downwards, gradient, n); // how far this part alone moves the fit
        if (!moved)
            return errors;
        used += gradient != MapChange{};
        for (std::size_t k = 0; k < n; ++k)
            for (std::size_t l = 0; l < n; ++l)
                covariance[k][l] += (*moved)[k] * (*moved)[l];
    }
    const double correction = used > n ? used / (used - n) : 1;
    for (int i = 0; i < 5; ++i) {
        double variance = 0;
        for (std::size_t k = 0; k < n; ++k)
            for (std::size_t l = 0; l < n; ++l)
                variance += free[k][i] * covariance[k][l] * free[l][i];
        errors.deviation[i] = std::sqrt(std::max(0.0, correction * variance));
    }
    errors.across = std::sqrt(std::max(0.0, correction * covariance[n - 1][n - 1]));
    errors.known = true;
    return errors;
}

} // namespace integral
