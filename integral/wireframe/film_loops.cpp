// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/wireframe/film_loops.h"

#include "integral/optics/beam.h"

#include <algorithm>

#include "integral/base/vector_loops.h"

namespace integral {

INTEGRAL_VECTORS void project(const PoleView& view, FilmChunk& chunk)
{
    // Copies: the compiler must know that the stores below cannot change the inputs.
    const Medium medium = view.medium;
    const Film film = view.film;
    const Vec2 pole = view.pole, shift = view.shift;
    const double turned = view.mirrored ? 1 : 0, columns = view.columns, rows = view.rows,
                 left = view.left - 1.0, top = view.top - 1.0;
    const int stride = view.stride;
    for (int k = 0; k < FilmChunk::most; ++k) {
        Vec2 at = film_point_through_pole(medium, pole, {chunk.x[k], chunk.y[k], chunk.z[k]});
        const Vec2 mirrored = at + 2 * (pole - at);
        at = {turned > 0 ? mirrored.x : at.x, turned > 0 ? mirrored.y : at.y};
        const Vec2 pixel = pixel_from_film(film, at) - shift;
        chunk.across[k] = pixel.x;
        chunk.down[k] = pixel.y;
        const double column = std::min(std::max(pixel.x - left, 0.0), columns + 1),
                     row = std::min(std::max(pixel.y - top, 0.0), rows + 1);
        chunk.place[k] = int(row) * stride + int(column);
    }
}

INTEGRAL_VECTORS void find_extents(const PoleView& view, const FilmChunk& chunk,
                                   FilmExtent* extents)
{
    const float columns = float(view.columns) + extent_beside,
                rows = float(view.rows) + extent_beside;
    for (int k = 0; k < FilmChunk::most; ++k) {
        const float x = float(chunk.across[k] - view.left), y = float(chunk.down[k] - view.top),
                    u = std::min(std::max(x, -extent_beside), columns),
                    v = std::min(std::max(y, -extent_beside), rows);
        extents[k] = FilmExtent{u, v, -u, -v};
    }
}

} // namespace integral
