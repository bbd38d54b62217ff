// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/replay/draft_frame.h"

#include "integral/optics/lens_mapping.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

constexpr double most_pixels = 40e6;

/// The lens that images each pixel of a film, row by row.
class PixelLenses {
public:
    PixelLenses(const FrameMetadata& metadata, int threads)
        : film_(metadata.film),
          optics_(metadata.sheet, metadata.aperture, metadata.render->model),
          mapping_(metadata.render->mapping),
          lenses_(std::size_t(film_.width) * film_.height)
    {
        for_each_row(film_.height, threads, [&](int y) {
            for (int x = 0; x < film_.width; ++x)
                lenses_[std::size_t(y) * film_.width + x] =
                    lens_of(film_from_pixel(film_, {x + 0.5, y + 0.5}));
        });
    }

    std::optional<LensIndex> lens_of(Vec2 film_point) const
    {
        const auto ray = optics_.map(film_point, mapping_).ray;
        return ray ? std::optional(ray->lens) : std::nullopt;
    }
    const std::optional<LensIndex>& at(int x, int y) const
    {
        return lenses_[std::size_t(y) * film_.width + x];
    }

private:
    Film film_;
    SheetOptics optics_;
    LensMapping mapping_;
    std::vector<std::optional<LensIndex>> lenses_;
};

/// The lens's pixel that is nearest to a place within the 5 x 5 around it, else the pixel there.
Colour nearest_of_lens(const LinearReader& pixel, const PixelLenses& lenses, const Film& film,
                       Vec2 place, LensIndex lens)
{
    const int column = int(place.x), row = int(place.y);
    Colour nearest = pixel(column, row);
    double least = 9;
    for (int j = std::max(0, row - 2); j <= std::min(film.height - 1, row + 2); ++j)
        for (int i = std::max(0, column - 2); i <= std::min(film.width - 1, column + 2); ++i) {
            const double distance = std::hypot(place.x - 0.5 - i, place.y - 0.5 - j);
            if (distance < least && lenses.at(i, j) == lens) {
                least = distance;
                nearest = pixel(i, j);
            }
        }
    return nearest;
}

/// The light at a place (pixel coordinates) that `lens` images: bilinear between the four nearest
/// pixels, leaving out pixels of other lenses. If none of the four is left, as in a lens's corner:
/// nearest_of_lens.
Colour light_at(const LinearReader& pixel, const PixelLenses& lenses, const Film& film, Vec2 place,
                LensIndex lens)
{
    const int left = int(std::floor(place.x - 0.5)), top = int(std::floor(place.y - 0.5));
    Colour sum{0, 0, 0, 0};
    float weights = 0;
    for (int j = std::max(0, top); j <= std::min(film.height - 1, top + 1); ++j)
        for (int i = std::max(0, left); i <= std::min(film.width - 1, left + 1); ++i) {
            const double x = place.x - 0.5 - i, y = place.y - 0.5 - j;
            const float weight = float(std::max(0.0, 1 - std::fabs(x)) *
                                       std::max(0.0, 1 - std::fabs(y)));
            if (!(weight > 0) || lenses.at(i, j) != lens)
                continue;
            const Colour c = pixel(i, j);
            weights += weight;
            sum = {sum.r + weight * c.r, sum.g + weight * c.g, sum.b + weight * c.b,
                   sum.a + weight * c.a};
        }
    if (!(weights > 0))
        return nearest_of_lens(pixel, lenses, film, place, lens);
    const float share = 1 / weights;
    return {share * sum.r, share * sum.g, share * sum.b, share * sum.a};
}

} // namespace

bool is_draft(const Frame& frame)
{
    return frame.metadata && frame.metadata->render && frame.metadata->render->draft > 1 &&
           frame.metadata->film.subpixels == Subpixels::none;
}

std::optional<Frame> with_final_pixels(const Frame& draft, int threads, const Progress& progress)
{
    const FrameMetadata& metadata = *draft.metadata;
    const Film& film = metadata.film;
    const int affordable = int(std::sqrt(most_pixels / (double(film.width) * film.height))),
              finer = std::clamp(affordable, 1, metadata.render->draft);
    Frame result{blank_like(draft.image, finer * film.width, finer * film.height), metadata};
    Film& fine = result.metadata->film;
    fine.width *= finer;
    fine.height *= finer;
    fine.pixel_pitch = (1.0 / finer) * fine.pixel_pitch;
    result.metadata->render->draft = 1;

    const PixelLenses lenses(metadata, threads);
    const LinearReader pixel(draft.image);
    const auto row = [&](int y) {
        for (int x = 0; x < fine.width; ++x) {
            const Vec2 place{(x + 0.5) / finer, (y + 0.5) / finer};
            if (const auto lens = lenses.lens_of(film_from_pixel(film, place)))
                store_linear(result.image, x, y, light_at(pixel, lenses, film, place, *lens));
        }
    };
    if (!for_each_row(fine.height, threads, row, progress))
        return std::nullopt;
    return result;
}

} // namespace integral
