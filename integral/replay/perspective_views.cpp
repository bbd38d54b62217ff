// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/replay/perspective_views.h"

#include "integral/lightfield/eye_place.h"
#include "integral/replay/interpolate.h"

#include <stdexcept>
#include <string>

namespace integral {

std::optional<Image> frame_from_perspective_views(const std::vector<Image>& views,
                                                  const FrameMetadata& metadata, ViewGrid grid,
                                                  EyeGrid eyes, int threads,
                                                  const Progress& progress)
{
    if (int(views.size()) != grid.count())
        throw std::invalid_argument("there are " + std::to_string(views.size()) + " views, not " +
                                    std::to_string(grid.count()));
    for (const Image& view : views)
        if (!same_form(view, views[0]))
            throw std::invalid_argument("its views differ in size or form");
    const Film& film = metadata.film;
    const SheetOptics optics(metadata.sheet, metadata.aperture);
    const Film window{views[0].width,
                      views[0].height,
                      {film.width * film.pixel_pitch.x / views[0].width,
                       film.height * film.pixel_pitch.y / views[0].height}};
    std::vector<LinearReader> light;
    for (const Image& view : views)
        light.emplace_back(view);

    const auto seen_by = [&](Vec2 film_point) {
        const auto seen = eye_place(optics, eyes, film_point);
        if (!seen)
            return Colour{0, 0, 0, 0};
        const Vec2 at = pixel_from_film(window, seen->place);
        const double across = seen->eye.x * grid.columns - 0.5, up = seen->eye.y * grid.rows - 0.5;
        return between(across, up, grid.columns, grid.rows, [&](int i, int j) {
            const LinearReader& view = light[std::size_t(j) * grid.columns + i];
            return between(at.x - 0.5, at.y - 0.5, window.width, window.height,
                           [&](int x, int y) { return view(x, y); });
        });
    };
    Image image = blank_like(views[0], film.width, film.height);
    const auto row = [&](int y) {
        for (int x = 0; x < film.width; ++x)
            store_linear(image, x, y, each_channel(film.subpixels, [&](int channel) {
                             return seen_by(film_from_pixel(
                                 film, subpixel_centre(film.subpixels, x, y, channel)));
                         }));
    };
    if (!for_each_row(film.height, threads, row, progress))
        return std::nullopt;
    return image;
}

} // namespace integral
