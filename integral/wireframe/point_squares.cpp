// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/wireframe/point_squares.h"

#include <algorithm>

namespace integral {
namespace {

/// Extent along an axis without the outermost hundredths of the points, which may be strays.
double extent(std::vector<double>& places)
{
    const std::size_t stray = places.size() / 100;
    const auto least = places.begin() + std::ptrdiff_t(stray),
               most = places.end() - 1 - std::ptrdiff_t(stray);
    std::nth_element(places.begin(), least, places.end());
    const double from = *least;
    std::nth_element(places.begin(), most, places.end());
    return *most - from;
}

} // namespace

double joining_size(const Mesh& cloud, double most)
{
    if (cloud.points.empty())
        return 0;
    std::vector<double> x, y;
    for (const MeshPoint& point : cloud.points) {
        x.push_back(cloud.vertices[point.vertex].x);
        y.push_back(cloud.vertices[point.vertex].y);
    }
    return std::min(std::sqrt(2 * extent(x) * extent(y) / double(cloud.points.size())), most);
}

void add_squares(Mesh& cloud, double side)
{
    const double half = 0.5 * side;
    for (const MeshPoint& point : cloud.points) {
        const Vec3 at = cloud.vertices[point.vertex];
        const auto first = std::uint32_t(cloud.vertices.size());
        for (const Vec2 corner :
             {Vec2{-half, -half}, Vec2{half, -half}, Vec2{half, half}, Vec2{-half, half}})
            cloud.vertices.push_back({at.x + corner.x, at.y + corner.y, at.z});
        cloud.triangles.push_back({{first, first + 1, first + 2}, point.colour});
        cloud.triangles.push_back({{first, first + 2, first + 3}, point.colour});
    }
}

} // namespace integral
