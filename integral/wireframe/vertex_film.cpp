// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/wireframe/vertex_film.h"

#include <algorithm>

namespace integral {

VertexFilm::VertexFilm(const WireframeRequest& request, const BlockMesh& block, Vec2 shift)
    : request_(request),
      block_(block),
      shift_(shift),
      state_(block.mesh.vertices.size()),
      list_(block.lenses.size() + FilmChunk::most)
{
}

void VertexFilm::begin(LensIndex lens, int number, const std::vector<LensPoint>& rays,
                       const LensRaster& raster)
{
    lens_ = lens;
    rays_ = &rays;
    pixel_.resize(state_.size() * rays.size());
    ++generation_;
    constexpr int most = 4096; // so that float resolves parts of pixels
    together_ = !block_.lenses.empty() && raster.is_upright() && raster.columns() <= most &&
                raster.rows() <= most;
    if (together_)
        project_together(number, raster);
}

std::size_t VertexFilm::list_vertices(int number)
{
    std::size_t count = 0;
    for (std::size_t k = 0; k < block_.lenses.size(); ++k) {
        list_[count] = std::uint32_t(k);
        count += block_.lenses[k] >> number & 1;
    }
    return count;
}

/// Sets a chunk's first `count` points to the vertices in the list.
static void set_points(const std::vector<Vec3>& vertices, const std::uint32_t* list,
                       std::size_t count, FilmChunk& chunk)
{
    for (std::size_t k = 0; k < count; ++k) {
        const Vec3 v = vertices[list[k]];
        chunk.x[k] = v.x;
        chunk.y[k] = v.y;
        chunk.z[k] = v.z;
    }
}

void VertexFilm::project_together(int number, const LensRaster& raster)
{
    const PixelBox& box = raster.box();
    const PoleView view{request_.optics.medium(),
                        request_.optics.lattice().pole(lens_),
                        request_.pseudoscopic,
                        request_.film,
                        shift_,
                        box.left,
                        box.top,
                        raster.columns(),
                        raster.rows(),
                        raster.stride()};
    const auto& vertices = block_.mesh.vertices;
    const std::size_t count = list_vertices(number);
    places_.assign(vertices.size(), raster.nowhere());
    const bool faces = !block_.far_triangles.empty();
    if (faces)
        extents_.resize(vertices.size());
    FilmChunk chunk;
    std::fill(std::begin(chunk.z), std::end(chunk.z), 1.0);
    std::fill(std::begin(chunk.x), std::end(chunk.x), 0.0);
    std::fill(std::begin(chunk.y), std::end(chunk.y), 0.0);
    std::array<FilmExtent, FilmChunk::most> extents;
    for (std::size_t first = 0; first < count; first += FilmChunk::most) {
        const std::size_t n = std::min(count - first, std::size_t(FilmChunk::most));
        const std::uint32_t* list = &list_[first];
        set_points(vertices, list, n, chunk);
        integral::project(view, chunk);
        for (std::size_t k = 0; k < n; ++k) {
            pixel_[list[k]] = {chunk.across[k], chunk.down[k]};
            places_[list[k]] = chunk.place[k];
            state_[list[k]] = 2 * generation_ + 1;
        }
        if (!faces)
            continue;
        find_extents(view, chunk, extents.data());
        for (std::size_t k = 0; k < n; ++k)
            extents_[list[k]] = extents[k];
    }
    projections_ += double(count);
}

bool VertexFilm::project(Vec3 point, Vec2* pixel) const
{
    for (const LensPoint& ray : *rays_) {
        const auto at = film_point_imaging(request_.optics, point, lens_, ray);
        if (!at)
            return false;
        const Vec2 shown = request_.pseudoscopic ? mirrored_in_lens(request_.optics, *at, lens_)
                                                 : *at;
        *pixel++ = pixel_from_film(request_.film, shown) - shift_;
    }
    return true;
}

const Vec2* VertexFilm::of(std::uint32_t vertex)
{
    Vec2* pixel = &pixel_[vertex * rays_->size()];
    std::uint32_t& state = state_[vertex];
    if (state / 2 != generation_) {
        state = 2 * generation_ + project(block_.mesh.vertices[vertex], pixel);
        ++projections_;
    }
    return state % 2 ? pixel : nullptr;
}

const Vec2* VertexFilm::of_point(Vec3 point)
{
    return project(point, single_.data()) ? single_.data() : nullptr;
}

} // namespace integral
