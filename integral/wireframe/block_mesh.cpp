// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/wireframe/block_mesh.h"

#include <algorithm>
#include <utility>

namespace integral {
namespace {

constexpr std::uint32_t none = UINT32_MAX;

template <std::size_t corners>
LensRange range_of(const Mesh& mesh, const LensReach& reach,
                   const std::array<std::uint32_t, corners>& vertex)
{
    std::array<Vec3, corners> corner;
    for (std::size_t k = 0; k < corners; ++k)
        corner[k] = mesh.vertices[vertex[k]];
    return reach.of(corner.data(), corners);
}

std::array<std::uint32_t, 1> vertices_of(const MeshPoint& point) { return {point.vertex}; }
template <class Thing> auto vertices_of(const Thing& thing) { return thing.vertex; }

/// Copies vertices into a smaller mesh, each when first requested.
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
    : mesh_(request.mesh), window_(window), limits_(depth_limits(request))
{
    const SheetOptics& optics = request.optics;
    const bool lenticular = optics.sheet().arrangement == Arrangement::lenticular,
               curved = refracts_at_surface(optics.model());
    together_ = !lenticular && !curved;
    side_ = lenticular ? 1 : 8;
    const LensReach reach(optics, window, curved ? optics.sheet().pitch : 0,
                          eye_depth(optics, request.pseudoscopic));
    sort(
        0, mesh_.points.size(), [&](std::uint32_t k) { return mesh_.points[k]; }, reach);
    const std::size_t edges = request.faces == FaceStyle::flat ? 0 : mesh_.face_edges.size();
    sort(
        1, mesh_.lines.size() + edges, [&](std::uint32_t k) { return line(k); }, reach);
    const std::size_t faces = request.faces == FaceStyle::wire ? 0 : mesh_.triangles.size();
    sort(
        2, faces, [&](std::uint32_t k) { return mesh_.triangles[k]; }, reach);
    for (const auto& of_kind : ranges_)
        bins_.emplace_back(of_kind, window, side_);
}

/// Sets order_ and ranges_ for one kind: points, lines or triangles.
template <class ThingAt>
void MeshBlocks::sort(std::size_t kind, std::size_t count, const ThingAt& thing_at,
                      const LensReach& reach)
{
    std::vector<std::pair<float, std::uint32_t>> by_depth(count);
    for (std::uint32_t k = 0; k < count; ++k)
        by_depth[k] = {together_ ? nearest(vertices_of(thing_at(k))) : 0, k};
    std::sort(by_depth.begin(), by_depth.end());
    for (const auto& [depth, k] : by_depth) {
        order_[kind].push_back(k);
        ranges_[kind].push_back(range_of(mesh_, reach, vertices_of(thing_at(k))));
    }
}

bool MeshBlocks::is_far(const std::uint32_t* vertices, std::size_t count) const
{
    double least = 1e300, most = -1e300;
    for (std::size_t k = 0; k < count; ++k) {
        const double z = mesh_.vertices[vertices[k]].z;
        least = std::min(least, z);
        most = std::max(most, z);
    }
    return together_ && limits_.is_far(least, most);
}

/// The mask of BlockMesh::lenses for a range that meets the block.
std::uint64_t MeshBlocks::lenses_in_block(int number, const LensRange& range) const
{
    const int columns = bins_[0].columns();
    const int left = window_.i + number % columns * side_,
              top = window_.j + number / columns * side_;
    const auto within = [&](int lens, int first) { return std::clamp(lens - first, 0, side_ - 1); };
    const int first = within(range.i, left), last = within(range.last_i, left);
    const std::uint64_t row = ((std::uint64_t(2) << (last - first)) - 1) << first;
    std::uint64_t lenses = 0;
    for (int k = within(range.j, top); k <= within(range.last_j, top); ++k)
        lenses |= row << (k * side_);
    return lenses;
}

BlockMesh MeshBlocks::block(int number) const
{
    BlockMesh part;
    VertexTaker vertices(mesh_.vertices, part.mesh.vertices);
    const auto needs = [&](const LensRange& range, const std::uint32_t* vertex, std::size_t count) {
        part.lenses.resize(part.mesh.vertices.size());
        const std::uint64_t lenses = lenses_in_block(number, range);
        for (std::size_t k = 0; k < count; ++k)
            part.lenses[vertex[k]] |= lenses;
    };
    const auto take = [&](std::size_t kind, auto& things, auto& far_things, auto& fronts,
                          const auto& thing_at) {
        const LensBins& bins = bins_[kind];
        for (const std::uint32_t* k = bins.begin(number); k != bins.end(number); ++k) {
            auto thing = thing_at(order_[kind][*k]);
            const bool far = is_far(thing.vertex.data(), thing.vertex.size());
            const float front = nearest(thing.vertex);
            vertices.renumber(thing.vertex);
            if (far) {
                needs(ranges_[kind][*k], thing.vertex.data(), thing.vertex.size());
                far_things.push_back(thing);
                fronts.push_back({thing.vertex, front});
            } else {
                part.ranges[kind].push_back(ranges_[kind][*k]);
                things.push_back(thing);
            }
        }
    };
    const LensBins& points = bins_[0];
    for (const std::uint32_t* k = points.begin(number); k != points.end(number); ++k) {
        MeshPoint point = mesh_.points[order_[0][*k]];
        const bool far = is_far(&point.vertex, 1);
        vertices.renumber(point.vertex);
        if (far)
            needs(ranges_[0][*k], &point.vertex, 1);
        part.mesh.points.push_back(point);
        part.ranges[0].push_back(ranges_[0][*k]);
    }
    take(1, part.mesh.lines, part.far_lines, part.line_fronts,
         [&](std::uint32_t k) { return line(k); });
    take(2, part.mesh.triangles, part.far_triangles, part.triangle_fronts,
         [&](std::uint32_t k) { return mesh_.triangles[k]; });
    return part;
}

} // namespace integral
