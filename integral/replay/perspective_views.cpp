// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/replay/perspective_views.h"

#include "integral/optics/lens_mapping.h"
#include "integral/replay/interpolate.h"

#include <stdexcept>
#include <string>

namespace integral {

std::optional<Image> frame_from_perspective_views(const std::vector<Image>& views, const FrameMetadata& metadata, ViewGrid grid,
                                                  EyeGrid eyes, int threads, const Progress& progress)
{
    if (int(views.size()) != grid.count())
        throw std::invalid_argument("there are " + std::to_string(views.size()) + " views, not " + std::to_string(grid.count()));
    for (const Image& view : views)
        if (!same_form(view, views[0]))
            throw std::invalid_argument("its views differ in size or form");
    const Film& film = metadata.film;
    const SheetOptics optics(metadata.sheet, metadata.aperture);
    const Film window{views[0].width, views[0].height,
                      {film.width * film.pixel_pitch.x / views[0].width, film.height * film.pixel_pitch.y / views[0].height}};
    std::vector<LinearReader> light;
    for (const Image& view : views)
        light.emplace_back(view);

    const auto seen_by = [&](Vec2 film_point) {
        const auto ray = optics.map(film_point, LensMapping::automatic).ray;
        if (!ray)
            return Color{0, 0, 0, 0};
        const double along = -eyes.distance / ray->direction.z;
        const Vec2 eye = ray->pole + along * Vec2{ray->direction.x, ray->direction.y};
        const Vec2 at = pixel_from_film(window, ray->pole);
        const double across = eyes.zone.x > 0 ? (eye.x / eyes.zone.x + 0.5) * grid.columns - 0.5 : 0;
        const double up = eyes.zone.y > 0 ? (eye.y / eyes.zone.y + 0.5) * grid.rows - 0.5 : 0;
        return between(across, up, grid.columns, grid.rows, [&](int i, int j) {
            const LinearReader& view = light[std::size_t(j) * grid.columns + i];
            return between(at.x - 0.5, at.y - 0.5, window.width, window.height, [&](int x, int y) { return view(x, y); });
        });
    };
    Image image = blank_like(views[0], film.width, film.height);
    const auto row = [&](int y) {
        for (int x = 0; x < film.width; ++x)
            store_linear(image, x, y, each_channel(film.subpixels, [&](int channel) {
                return seen_by(film_from_pixel(film, subpixel_centre(film.subpixels, x, y, channel)));
            }));
    };
    if (!for_each_row(film.height, threads, row, progress))
        return std::nullopt;
    return image;
}

} // namespace integral
