// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/replay/replay.h"

#include <algorithm>
#include <cmath>

namespace integral {

Eye centre_eye(const FrameMetadata& metadata)
{
    return {0, 0, metadata.aperture.distance};
}

void set_view_size(View& view, const Film& film, int longer)
{
    const double width = film.width * film.pixel_pitch.x, height = film.height * film.pixel_pitch.y;
    const double scale = longer / std::max(width, height);
    view.width = std::max(1, int(std::lround(width * scale)));
    view.height = std::max(1, int(std::lround(height * scale)));
}

namespace {

/// What the eye sees at a point of the sheet: linear, premultiplied.
class SheetSeen {
public:
    SheetSeen(const Frame& frame, Eye eye)
        : film_(frame.metadata->film), eye_(eye),
          optics_(frame.metadata->sheet, frame.metadata->aperture), pixel_(frame.image),
          outside_{0, 0, 0, frame.image.channels == 4 ? 0.0f : 1.0f}
    {
    }

    Color at(Vec2 point) const
    {
        // The line from the sheet's point to the eye leaves the sheet in this direction ...
        const Vec3 to_eye{eye_.x - point.x, eye_.y - point.y, -eye_.distance};
        const Vec3 direction = (1 / length(to_eye)) * to_eye;
        // ... and the beam of that direction, from that point's lens, comes from this film point.
        const Vec2 pixel = pixel_from_film(film_, optics_.film_point_seen(point, direction));
        if (!(pixel.x >= 0 && pixel.x < film_.width && pixel.y >= 0 && pixel.y < film_.height))
            return outside_;
        return film_.subpixels == Subpixels::none ? pixel_(int(pixel.x), int(pixel.y)) : stripes_at(pixel);
    }

private:
    /// Each colour channel of its own nearest stripe; their pixels' mean alpha.
    Color stripes_at(Vec2 pixel) const
    {
        const auto nearest = [&](int channel) {
            const int column = int(std::floor(pixel.x - subpixel_shift(film_.subpixels, channel)));
            return pixel_(std::clamp(column, 0, film_.width - 1), int(pixel.y));
        };
        const Color red = nearest(0), green = nearest(1), blue = nearest(2);
        return {red.r, green.g, blue.b, (red.a + green.a + blue.a) / 3};
    }

    Film film_;
    Eye eye_;
    SheetOptics optics_;
    LinearReader pixel_;
    Color outside_;
};

Image blank_view(const Frame& frame, const View& view)
{
    const Image& like = frame.image;
    const auto make = [&](auto sample) {
        return make_image<decltype(sample)>(view.width, view.height, like.channels, like.encoding);
    };
    Image image = sample_bits(like) == 8    ? make(std::uint8_t())
                  : sample_bits(like) == 16 ? make(std::uint16_t())
                                            : make(float());
    image.premultiplied = like.premultiplied;
    return image;
}

} // namespace

std::optional<Image> replay(const Frame& frame, const View& view, int threads,
                            const Progress& progress)
{
    const SheetSeen seen(frame, view.eye);
    const Film& film = frame.metadata->film;
    Image image = blank_view(frame, view);

    // The view's pixels, as a film of their own over the same rectangle.
    const Film grid{view.width, view.height,
                    {film.width * film.pixel_pitch.x / view.width,
                     film.height * film.pixel_pitch.y / view.height}};
    const int n = view.samples;
    const auto row = [&](int y) {
        for (int x = 0; x < view.width; ++x) {
            double r = 0, g = 0, b = 0, a = 0;
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i) {
                    const Color c = seen.at(
                        film_from_pixel(grid, {x + (i + 0.5) / n, y + (j + 0.5) / n}));
                    r += c.r;
                    g += c.g;
                    b += c.b;
                    a += c.a;
                }
            const double weight = 1.0 / (double(n) * n);
            store_linear(image, x, y,
                         {float(r * weight), float(g * weight), float(b * weight),
                          float(a * weight)});
        }
    };
    if (!for_each_row(view.height, threads, row, progress))
        return std::nullopt;
    return image;
}

} // namespace integral
