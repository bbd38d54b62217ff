// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/sampling/quilt_sampler.h"

#include "integral/frame/view_eyes.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace integral {

QuiltSampler::QuiltSampler(const IntegralCamera& camera, ViewGrid tiles, int width, int height)
    : tiles_(tiles),
      directions_(directions_of(tiles, camera.optics.sheet())),
      eyes_{viewing_zone(camera.optics.sheet(), camera.optics.aperture()),
            camera.optics.aperture().distance},
      window_{camera.film.width * camera.film.pixel_pitch.x,
              camera.film.height * camera.film.pixel_pitch.y},
      tile_width_(width / tiles.columns),
      tile_height_(height / tiles.rows),
      left_over_(height - tile_height_ * tiles.rows)
{
    if (tile_width_ < 1 || tile_height_ < 1)
        throw std::invalid_argument("a picture of " + std::to_string(width) + "x" +
                                    std::to_string(height) + " pixels has no room for " +
                                    std::to_string(tiles.columns) + "x" +
                                    std::to_string(tiles.rows) + " views; give a larger +W and +H");
}

std::optional<BeamRay> QuiltSampler::ray(Vec2 pixel) const
{
    const double across = pixel.x / tile_width_, down = (pixel.y - left_over_) / tile_height_;
    const int column = int(std::floor(across)), row = tiles_.rows - 1 - int(std::floor(down));
    if (column < 0 || column >= tiles_.columns || row < 0 || row >= tiles_.rows)
        return std::nullopt;
    const Vec2 eye = eye_of_view(eyes_, directions_, row * tiles_.columns + column);
    const Vec3 point{(across - column - 0.5) * window_.x,
                     (0.5 - (down - (tiles_.rows - 1 - row))) * window_.y, 0};
    const Vec3 to_eye{eye.x - point.x, eye.y - point.y, -eyes_.distance};
    return BeamRay{point, (1 / length(to_eye)) * to_eye, eye};
}

} // namespace integral
