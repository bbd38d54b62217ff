// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/border_slope.h"

#include "integral/analysis/least_squares.h"

#include <cmath>

namespace integral {

std::optional<Local> local(const Plane& plane, Vec2 pixel)
{
    const double x = pixel.x - 0.5, y = pixel.y - 0.5;
    if (!(x >= 2 && y >= 2 && std::floor(x) + 3 < plane.width &&
          std::floor(y) + 3 < plane.height)) // the search may step far outside
        return std::nullopt;
    const int left = int(std::floor(x)), top = int(std::floor(y));
    const double u = x - left, v = y - top;
    double s[3][3]; // one pixel apart, around the place itself
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

std::optional<MapChange> solve(const Matrix& a, const MapChange& b, std::size_t n)
{
    SquareMatrix matrix(n);
    for (std::size_t k = 0; k < n; ++k)
        std::copy_n(a[k].begin(), n, &matrix.at(k, 0));
    const auto solved = solve_positive(std::move(matrix), {b.begin(), b.begin() + n}, 0);
    if (!solved)
        return std::nullopt;
    MapChange change = b;
    std::copy(solved->begin(), solved->end(), change.begin());
    return change;
}

MapChange combined(const std::vector<MapChange>& free, const MapChange& amounts)
{
    MapChange change{};
    for (std::size_t k = 0; k < free.size(); ++k)
        for (int i = 0; i < 5; ++i)
            change[i] += amounts[k] * free[k][i];
    return change;
}

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

} // namespace integral
