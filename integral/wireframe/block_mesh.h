// SPDX-License-Identifier: AGPL-3.0-or-later
// A mesh by blocks of neighbouring lenses: what the lenses of one block may image, in arrays that
// the processor's caches hold while lens after lens draws it.
#ifndef INTEGRAL_WIREFRAME_BLOCK_MESH_H
#define INTEGRAL_WIREFRAME_BLOCK_MESH_H

#include "integral/wireframe/depth_limits.h"
#include "integral/wireframe/lens_bins.h"
#include "integral/wireframe/wireframe.h"

#include <array>
#include <vector>

namespace integral {

/// What is needed of a line or triangle in order to see that nothing of it is in front.
template <std::size_t corners> struct FarThing {
    std::array<std::uint32_t, corners> vertex;
    float nearest; ///< the least z of its vertices, mm
};

/// A part of a mesh: vertices are numbered anew. Where there are far things, all come from the
/// front to the back, by their nearest vertices, since what is drawn first hides most of what
/// follows.
struct BlockMesh {
    Mesh mesh; ///< its lines: those of the mesh, then the faces' edges
    /// The lenses that may image each of its points, lines and triangles.
    std::array<std::vector<LensRange>, 3> ranges;

    /// Behind square and hexagonal lenses whose model has one ray, through the pole: what is far
    /// (DepthLimits::is_far) is here instead. Else these are empty.
    std::vector<MeshLine> far_lines;
    std::vector<MeshTriangle> far_triangles;
    std::vector<FarThing<2>> line_fronts;     ///< of each far line
    std::vector<FarThing<3>> triangle_fronts; ///< of each far triangle
    /// Of each vertex, for each lens of the block by number_in_block: whether the lens may image
    /// one of the points and far things that the vertex belongs to.
    std::vector<std::uint64_t> lenses;
};

/// What is to be drawn of a request's mesh, by blocks of lenses. Immutable.
class MeshBlocks {
public:
    /// `window`: the lenses that there are. The request must outlive this.
    MeshBlocks(const WireframeRequest& request, const LensRange& window);

    int count() const { return bins_[0].blocks(); }
    int block_of(LensIndex lens) const { return bins_[0].block_of(lens); }
    /// 0 to 63, by rows.
    int number_in_block(LensIndex lens) const
    {
        return int(lens.j - window_.j) % side_ * side_ + int(lens.i - window_.i) % side_;
    }
    BlockMesh block(int number) const;

private:
    bool is_far(const std::uint32_t* vertices, std::size_t count) const;
    std::uint64_t lenses_in_block(int number, const LensRange& range) const;
    /// The mesh's lines, then its faces' edges.
    const MeshLine& line(std::uint32_t k) const
    {
        const auto& lines = mesh_.lines;
        return k < lines.size() ? lines[k] : mesh_.face_edges[k - lines.size()];
    }
    template <std::size_t corners>
    float nearest(const std::array<std::uint32_t, corners>& vertex) const
    {
        double least = mesh_.vertices[vertex[0]].z;
        for (const std::uint32_t v : vertex)
            least = std::min(least, mesh_.vertices[v].z);
        return float(least);
    }
    template <class ThingAt>
    void sort(std::size_t kind, std::size_t count, const ThingAt& thing_at, const LensReach& reach);

    const Mesh& mesh_;
    LensRange window_;
    DepthLimits limits_;
    bool together_; ///< whether there are far things
    int side_;      ///< lenses along a block's side
    /// Numbers of points, lines and triangles in the order of their drawing, and their ranges.
    std::array<std::vector<std::uint32_t>, 3> order_;
    std::array<std::vector<LensRange>, 3> ranges_;
    std::vector<LensBins> bins_; ///< the same
};

} // namespace integral

#endif
