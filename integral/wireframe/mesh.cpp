// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/wireframe/mesh.h"

#include "integral/base/constants.h"
#include "integral/base/number_text.h"

#include <algorithm>
#include <stdexcept>

namespace integral {
namespace {

Vec3 times(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

/// POV-Ray's rotation: left-handed, about x, then y, then z.
Vec3 turned(Vec3 v, Vec3 degrees)
{
    const auto turn = [](double& a, double& b, double angle) {
        const double c = std::cos(angle * radians_per_degree),
                     s = std::sin(angle * radians_per_degree), old = a;
        a = c * old - s * b;
        b = s * old + c * b;
    };
    turn(v.y, v.z, degrees.x);
    turn(v.z, v.x, degrees.y);
    turn(v.x, v.y, degrees.z);
    return v;
}

/// Scales and moves the mesh so that its middle is at 0 and its largest extent is `fit`.
void fit_mesh(Mesh& mesh, double fit)
{
    Vec3 least = mesh.vertices.front(), most = least;
    for (const Vec3 v : mesh.vertices) {
        least = {std::min(least.x, v.x), std::min(least.y, v.y), std::min(least.z, v.z)};
        most = {std::max(most.x, v.x), std::max(most.y, v.y), std::max(most.z, v.z)};
    }
    const Vec3 extent = most - least, middle = 0.5 * (least + most);
    const double largest = std::max({extent.x, extent.y, extent.z});
    if (!(largest > 0))
        throw std::invalid_argument("all its vertices are at one place, so it cannot be fitted");
    for (Vec3& v : mesh.vertices)
        v = (fit / largest) * (v - middle);
}

void refuse_far(Vec3 v)
{
    const double far = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    if (!(far <= farthest_vertex))
        throw std::invalid_argument("a vertex is " + with_digits(far, 3) +
                                    " mm from the sheet; 1000000 mm are the limit, and --fit "
                                    "brings a mesh of any unit there");
}

} // namespace

void keep_each_edge_once(Mesh& mesh)
{
    auto& edges = mesh.face_edges;
    const auto less = [](const MeshLine& a, const MeshLine& b) { return a.vertex < b.vertex; };
    const auto same = [](const MeshLine& a, const MeshLine& b) { return a.vertex == b.vertex; };
    std::stable_sort(edges.begin(), edges.end(), less);
    edges.erase(std::unique(edges.begin(), edges.end(), same), edges.end());
}

void place(Mesh& mesh, const MeshPlace& place)
{
    if (mesh.vertices.empty())
        return;
    Vec3 scale = place.scale;
    if (place.fit > 0) {
        fit_mesh(mesh, place.fit);
        scale = {std::copysign(1.0, scale.x), std::copysign(1.0, scale.y),
                 std::copysign(1.0, scale.z)};
    }
    for (Vec3& v : mesh.vertices) {
        v = turned(times(scale, v), place.turn) + place.move;
        refuse_far(v);
    }
}

void show_in_relief(Mesh& mesh, const Collineation& relief)
{
    for (Vec3& v : mesh.vertices) {
        const auto seen = image_of(relief, v);
        if (!seen)
            throw std::invalid_argument(
                "with this parallax what is more than " +
                with_digits(std::fabs(1 / relief.bend), 4) + " mm " +
                (relief.bend < 0
                     ? "behind the sheet is seen beyond infinity; a parallax of at most 1 shows it"
                     : "before the sheet is behind every eye; leave it out"));
        refuse_far(v = *seen);
    }
}

} // namespace integral
