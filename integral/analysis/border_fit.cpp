// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/border_fit.h"

#include "integral/analysis/border_slope.h"

#include <algorithm>
#include <cmath>

namespace integral {

std::vector<MapChange> free_directions(const LensSheet& sheet, const ScanMap& map)
{
    if (sheet.arrangement != Arrangement::lenticular)
        return {
            {1, 0, 0, 0, 0}, {0, 1, 0, 0, 0}, {0, 0, 1, 0, 0}, {0, 0, 0, 1, 0}, {0, 0, 0, 0, 1}};
    // The direction across the lenses in the scan: the direction b across the sheet's lenses,
    // turned, and divided by the scales, as the normals of lines are.
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

ScanMap fit_borders(const Plane& edges, const std::vector<Vec2>& points, const LensSheet& sheet,
                    ScanMap map)
{
    return climb(edges, points, map,
                 [&](const ScanMap& here) { return free_directions(sheet, here); });
}

ScanMap fit_borders_with_ratio(const Plane& edges, const std::vector<Vec2>& points, ScanMap map)
{
    const std::vector<MapChange> free = {
        {1, 1, 0, 0, 0}, {0, 0, 1, 0, 0}, {0, 0, 0, 1, 0}, {0, 0, 0, 0, 1}};
    return climb(edges, points, map, [&](const ScanMap&) { return free; });
}

namespace {

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

} // namespace integral
