// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/views/perspective_views.h"

#include "integral/frame/eye_place.h"
#include "integral/replay/interpolate.h"

#include <stdexcept>
#include <string>

namespace integral {

struct FrameOfPerspectives::State {
    State(const std::vector<Image>& views, const FrameMetadata& metadata, ViewGrid grid,
          EyeGrid eyes, const FittedPicture& picture)
        : film(metadata.film),
          grid(grid),
          eyes(eyes),
          picture(picture),
          optics(metadata.sheet, metadata.aperture)
    {
        if (int(views.size()) != grid.count())
            throw std::invalid_argument("there are " + std::to_string(views.size()) +
                                        " views, not " + std::to_string(grid.count()));
        for (const Image& view : views)
            if (!same_form(view, views[0]))
                throw std::invalid_argument("its views differ in size or form");
        window = pixels_on(film, picture, views[0].width, views[0].height);
        for (const Image& view : views)
            light.emplace_back(view);
    }

    /// The light of the ray through a point of the film.
    Colour seen_by(Vec2 film_point) const
    {
        const auto seen = eye_place(optics, eyes, film_point);
        if (!seen)
            return Colour{0, 0, 0, 0};
        const Vec2 pixel = pixel_from_film(film, seen->place);
        if (picture.is_in_bar({pixel.x / film.width, pixel.y / film.height}))
            return Colour{0, 0, 0, 1};
        const Vec2 at = pixel_from_film(window, seen->place);
        const double across = seen->eye.x * grid.columns - 0.5, up = seen->eye.y * grid.rows - 0.5;
        return between(across, up, grid.columns, grid.rows, [&](int i, int j) {
            const LinearReader& view = light[std::size_t(j) * grid.columns + i];
            return between(at.x - 0.5, at.y - 0.5, window.width, window.height,
                           [&](int x, int y) { return view(x, y); });
        });
    }

    Film film;
    ViewGrid grid;
    EyeGrid eyes;
    FittedPicture picture;
    SheetOptics optics;
    Film window; ///< a view's pixels laid out over the sheet
    std::vector<LinearReader> light;
};

FrameOfPerspectives::FrameOfPerspectives(const std::vector<Image>& views,
                                         const FrameMetadata& metadata, ViewGrid grid, EyeGrid eyes,
                                         const FittedPicture& picture)
    : state_(std::make_unique<State>(views, metadata, grid, eyes, picture))
{
}
FrameOfPerspectives::~FrameOfPerspectives() = default;

bool FrameOfPerspectives::draw(int first, Image& band, int threads, const Progress& progress) const
{
    const State& s = *state_;
    return draw_film(s.film, first, band, threads, progress,
                     [&](Vec2 film_point, int, int) { return s.seen_by(film_point); });
}

std::optional<Image> frame_from_eye_views(const std::vector<Image>& views,
                                          const FrameMetadata& metadata, ViewGrid grid,
                                          EyeGrid eyes, int threads, const Progress& progress,
                                          const FittedPicture& picture)
{
    const FrameOfPerspectives frame(views, metadata, grid, eyes, picture);
    Image image = blank_like(views[0], metadata.film.width, metadata.film.height);
    if (!frame.draw(0, image, threads, progress))
        return std::nullopt;
    return image;
}

} // namespace integral
