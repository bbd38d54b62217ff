// SPDX-License-Identifier: AGPL-3.0-or-later
// Projects a mesh's vertices through one lens to the film.
#ifndef INTEGRAL_WIREFRAME_VERTEX_FILM_H
#define INTEGRAL_WIREFRAME_VERTEX_FILM_H

#include "integral/wireframe/block_mesh.h"
#include "integral/wireframe/film_loops.h"
#include "integral/wireframe/lens_raster.h"
#include "integral/wireframe/lens_rays.h"

#include <array>
#include <vector>

namespace integral {

/// The film points of a block's vertices, in continuous pixel coordinates, for one lens of the
/// block after another. If the lenses are square or hexagonal with one ray through the pole, the
/// vertices that the lens may image are projected together; other vertices are projected when first
/// requested.
class VertexFilm {
public:
    /// `shift`: offset of a colour's subpixels from their pixels' centres, in pixels, +y down.
    VertexFilm(const WireframeRequest& request, const BlockMesh& block, Vec2 shift);

    /// Discards all places. `number`: the lens's number in its block.
    void begin(LensIndex lens, int number, const std::vector<LensPoint>& rays,
               const LensRaster& raster);

    const BlockMesh& block() const { return block_; }
    /// The places of a vertex, one for each ray; nullptr if any ray has none.
    const Vec2* of(std::uint32_t vertex);
    /// The places of any scene point, valid until the next call.
    const Vec2* of_point(Vec3 point);
    double projections() const { return projections_; }

    /// Whether the vertices of the block's far things were projected together. Then places() is
    /// valid, and extents() if triangles are far.
    bool is_together() const { return together_; }
    /// Each vertex's place in the raster; nowhere() for vertices not projected together.
    const int* places() const { return places_.data(); }
    const FilmExtent* extents() const { return extents_.data(); }

private:
    bool project(Vec3 point, Vec2* pixel) const;
    /// Lists the block's vertices that the lens may image, in list_; returns their number.
    std::size_t list_vertices(int number);
    void project_together(int number, const LensRaster& raster);

    const WireframeRequest& request_;
    const BlockMesh& block_;
    Vec2 shift_;
    LensIndex lens_;
    const std::vector<LensPoint>* rays_ = nullptr;
    std::vector<Vec2> pixel_;
    std::vector<std::uint32_t> state_; ///< of each vertex: 2 generation_ + whether it has film
                                       ///< points
    std::uint32_t generation_ = 0;
    bool together_ = false;
    std::vector<std::uint32_t> list_; ///< vertices to project
    std::vector<int> places_;
    std::vector<FilmExtent> extents_;
    std::array<Vec2, 5> single_;
    double projections_ = 0;
};

} // namespace integral

#endif
