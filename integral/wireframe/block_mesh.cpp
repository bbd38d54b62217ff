// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/wireframe/block_mesh.h"

namespace integral {
namespace {

constexpr std::uint32_t none = UINT32_MAX;

LensRange range_of(const Mesh& mesh, const LensReach& reach, const MeshPoint& point)
{
    return reach.of(&mesh.vertices[point.vertex], 1);
}

template <class Thing>
LensRange range_of(const Mesh& mesh, const LensReach& reach, const Thing& thing)
{
    std::array<Vec3, 3> corner;
    const std::size_t n = thing.vertex.size();
    for (std::size_t k = 0; k < n; ++k)
        corner[k] = mesh.vertices[thing.vertex[k]];
    return reach.of(corner.data(), n);
}

/// Takes vertices over into a smaller mesh, each when it is first asked for.
class VertexTaker {
public:
    VertexTaker(const std::vector<Vec3>& from, std::vector<Vec3>& to)
        : from_(from), to_(to), number_(from.size(), none)
    {
    }
    void renumber(std::uint32_t& vertex)
    {
        std::uint32_t& number = number_[vertex];
        if (number == none) {
            number = std::uint32_t(to_.size());
            to_.push_back(from_[vertex]);
        }
        vertex = number;
    }
    template <std::size_t n> void renumber(std::array<std::uint32_t, n>& vertices)
    {
        for (std::uint32_t& vertex : vertices)
            renumber(vertex);
    }

private:
    const std::vector<Vec3>& from_;
    std::vector<Vec3>& to_;
    std::vector<std::uint32_t> number_;
};

} // namespace

MeshBlocks::MeshBlocks(const WireframeRequest& request, const LensRange& window)
    : mesh_(request.mesh)
{
    const SheetOptics& optics = request.optics;
    const bool lenticular = optics.sheet().arrangement == Arrangement::lenticular;
    const int block = lenticular ? 1 : 8;
    const LensReach reach(optics, window,
                          refracts_at_surface(optics.model()) ? optics.sheet().pitch : 0,
                          eye_depth(optics, request.pseudoscopic));
    const auto put = [&](const auto& things, auto& ranges) {
        for (const auto& thing : things)
            ranges.push_back(range_of(mesh_, reach, thing));
    };
    put(mesh_.points, ranges_[0]);
    put(mesh_.lines, ranges_[1]);
    if (request.faces != FaceStyle::flat)
        put(mesh_.face_edges, ranges_[1]);
    if (request.faces != FaceStyle::wire)
        put(mesh_.triangles, ranges_[2]);
    for (const auto& of_kind : ranges_)
        bins_.emplace_back(of_kind, window, block);
}

BlockMesh MeshBlocks::block(int number) const
{
    BlockMesh part;
    VertexTaker vertices(mesh_.vertices, part.mesh.vertices);
    const auto take = [&](std::size_t kind, auto& things, const auto& thing_at) {
        const LensBins& bins = bins_[kind];
        for (const std::uint32_t* k = bins.begin(number); k != bins.end(number); ++k) {
            things.push_back(thing_at(*k));
            vertices.renumber(things.back().vertex);
            part.ranges[kind].push_back(ranges_[kind][*k]);
        }
    };
    take(0, part.mesh.points, [&](std::uint32_t k) { return mesh_.points[k]; });
    take(1, part.mesh.lines, [&](std::uint32_t k) { return line(k); });
    take(2, part.mesh.triangles, [&](std::uint32_t k) { return mesh_.triangles[k]; });
    return part;
}

} // namespace integral
