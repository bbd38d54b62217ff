// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/wireframe/wireframe_report.h"

#include "integral/base/number_text.h"

#include <algorithm>

namespace integral {

std::string drawing_text(const Mesh& mesh, const WireframeCost& cost, double seconds)
{
    const double vertices = double(mesh.vertices.size());
    return with_digits(vertices, 9) + " vertices through " +
           with_decimals(cost.projections / std::max(vertices, 1.0), 1) + " of " +
           std::to_string(cost.lenses) + " lenses each: " + with_digits(cost.projections, 9) +
           " projections, " + with_decimals(seconds, 2) + " s";
}

Json drawing_json(const Mesh& mesh, const WireframeCost& cost, double seconds)
{
    return {{"vertices", mesh.vertices.size()},   {"points", mesh.points.size()},
            {"lines", mesh.lines.size()},         {"face_edges", mesh.face_edges.size()},
            {"triangles", mesh.triangles.size()}, {"lenses", cost.lenses},
            {"projections", cost.projections},    {"seconds", seconds}};
}

} // namespace integral
