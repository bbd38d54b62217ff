// SPDX-License-Identifier: AGPL-3.0-or-later
// A mesh by blocks of neighbouring lenses: what the lenses of one block may image, in arrays that
// the processor's caches hold while lens after lens draws it.
#ifndef INTEGRAL_WIREFRAME_BLOCK_MESH_H
#define INTEGRAL_WIREFRAME_BLOCK_MESH_H

#include "integral/wireframe/lens_bins.h"
#include "integral/wireframe/wireframe.h"

#include <array>
#include <vector>

namespace integral {

/// Vertices are numbered anew; things keep their order.
struct BlockMesh {
    Mesh mesh; ///< its lines: those of the mesh, then the faces' edges
    /// The lenses that may image each of its points, lines and triangles.
    std::array<std::vector<LensRange>, 3> ranges;
};

/// What is to be drawn of a request's mesh, by blocks of lenses. Immutable.
class MeshBlocks {
public:
    /// `window`: the lenses that there are. The request must outlive this.
    MeshBlocks(const WireframeRequest& request, const LensRange& window);

    int count() const { return bins_[0].blocks(); }
    int block_of(LensIndex lens) const { return bins_[0].block_of(lens); }
    BlockMesh block(int number) const;

private:
    const MeshLine& line(std::uint32_t k) const
    {
        const auto& lines = mesh_.lines;
        return k < lines.size() ? lines[k] : mesh_.face_edges[k - lines.size()];
    }

    const Mesh& mesh_;
    std::array<std::vector<LensRange>, 3> ranges_; ///< of points, lines, triangles
    std::vector<LensBins> bins_;                   ///< the same
};

} // namespace integral

#endif
