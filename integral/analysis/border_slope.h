// SPDX-License-Identifier: AGPL-3.0-or-later
// Computes the edge strength on the borders between micro-images, and the strength's derivatives
// with respect to a scan's map, for fits of the whole scan and of its parts.
#ifndef INTEGRAL_ANALYSIS_BORDER_SLOPE_H
#define INTEGRAL_ANALYSIS_BORDER_SLOPE_H

#include "integral/analysis/border_fit.h"

#include <algorithm>
#include <optional>

namespace integral {

/// A plane's value between its pixels' centres, with its slopes and curvatures as differences over
/// one pixel.
struct Local {
    double value, x, y, xx, xy, yy;
};

/// The plane at `pixel`; nothing within two pixels of the plane's sides.
std::optional<Local> local(const Plane& plane, Vec2 pixel);

/// Derivative of a point's place in the scan (pixels along x and y) by each free direction. c and s
/// are the cosine and sine of the map's rotation.
std::array<Vec2, 5> motion_of(const ScanMap& map, double c, double s,
                              const std::vector<MapChange>& free, Vec2 point);

using Matrix = std::array<std::array<double, 5>, 5>;

/// A sum over points, with its first and second derivatives along the free directions.
struct Slope {
    double value = 0;
    MapChange gradient{};
    Matrix curvature{};
};

/// Sum of the edge strength at the points, with its derivatives.
Slope slope_at(const Plane& edges, const std::vector<Vec2>& points, const ScanMap& map,
               const std::vector<MapChange>& free);

/// Solves a x = b for a symmetric positive definite a of `n` rows; returns nothing for any other a.
std::optional<MapChange> solve(const Matrix& a, const MapChange& b, std::size_t n);

/// Sum of the free directions, each times its amount.
MapChange combined(const std::vector<MapChange>& free, const MapChange& amounts);

/// The next step of a damped Newton search for the maximum; nothing if the damping is too weak for
/// the curvature.
std::optional<MapChange> newton_step(const Slope& here, const std::vector<MapChange>& free,
                                     double damping);

/// Climbs from `map` along free_of(map), by damped Newton steps, to the maximum of the edge
/// strength at the points.
template <class FreeOf>
ScanMap climb(const Plane& edges, const std::vector<Vec2>& points, ScanMap map, FreeOf free_of)
{
    double farthest = 0;
    for (const Vec2 point : points)
        farthest = std::max(farthest, length(point));
    const double radius = farthest * std::max(map.scale.x, map.scale.y);
    double damping = 1e-3;
    std::vector<MapChange> free = free_of(map);
    Slope here = slope_at(edges, points, map, free);
    for (int step = 0; step < 40 && damping < 1e8; ++step) {
        const auto change = newton_step(here, free, damping);
        if (!change) {
            damping = std::max(1e-2, 10 * damping);
            continue;
        }
        const auto& c = *change;
        const double moved = radius * (std::fabs(c[0]) + std::fabs(c[1]) + std::fabs(c[2])) +
                             std::fabs(c[3]) + std::fabs(c[4]);
        const ScanMap there = changed(map, c);
        const std::vector<MapChange> free_there = free_of(there);
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

/// Divides the film that the scan holds into `side` x `side` parts; returns the part of a point.
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

} // namespace integral

#endif
