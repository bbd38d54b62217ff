// SPDX-License-Identifier: AGPL-3.0-or-later
// Splits a mesh by blocks of neighbouring lenses: arrays of the things that a block's lenses may
// image, small enough for the processor's caches while lens after lens draws them.
#ifndef INTEGRAL_WIREFRAME_BLOCK_MESH_H
#define INTEGRAL_WIREFRAME_BLOCK_MESH_H

#include "integral/wireframe/depth_limits.h"
#include "integral/wireframe/lens_bins.h"
#include "integral/wireframe/wireframe.h"

#include <array>
#include <vector>

namespace integral {

/// Data of a far line or triangle for the test whether any part of it is in front of the drawing.
template <std::size_t corners> struct FarThing {
    std::array<std::uint32_t, corners> vertex;
    float nearest; ///< minimum z of its vertices, mm
};

/// Part of a mesh, with its vertices renumbered. If there are far lines or triangles, everything is
/// sorted from front to back by the nearest vertices, because what is drawn first hides most of
/// what is drawn later.
struct BlockMesh {
    Mesh mesh; ///< lines: the whole mesh's, then the faces' edges
    /// The lenses that may image each of its points, lines and triangles.
    std::array<std::vector<LensRange>, 3> ranges;

    /// The far lines and triangles: wholly on one side of their lenses (DepthLimits::is_far).
    /// `mesh` does not contain them. Empty unless the lenses are square or hexagonal and their
    /// model has one ray, through the pole.
    std::vector<MeshLine> far_lines;
    std::vector<MeshTriangle> far_triangles;
    std::vector<FarThing<2>> line_fronts;     ///< of each far line
    std::vector<FarThing<3>> triangle_fronts; ///< of each far triangle
    /// One mask for each vertex, with a bit for each lens of the block (number_in_block): whether
    /// the lens may image a point, or a far line or triangle, that has this vertex.
    std::vector<std::uint64_t> lenses;
};

/// The part of a request's mesh to draw, by blocks of lenses. Immutable.
class MeshBlocks {
public:
    /// `window`: the range of all lenses. The request must outlive this object.
    MeshBlocks(const WireframeRequest& request, const LensRange& window);

    int count() const { return bins_[0].blocks(); }
    int block_of(LensIndex lens) const { return bins_[0].block_of(lens); }
    /// Number of a lens in its block: 0 to 63, by rows.
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
    bool together_; ///< whether lines and triangles may be far
    int side_;      ///< lenses along a block's side
    /// Indices of points, lines and triangles in drawing order, and their ranges.
    std::array<std::vector<std::uint32_t>, 3> order_;
    std::array<std::vector<LensRange>, 3> ranges_;
    std::vector<LensBins> bins_; ///< of ranges_
};

} // namespace integral

#endif
