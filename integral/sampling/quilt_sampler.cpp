// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/sampling/quilt_sampler.h"

#include "integral/frame/view_eyes.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace integral {

namespace {

constexpr std::uint64_t first_samples = 1, further_samples = 2, reference_samples = 3;

} // namespace

QuiltSampler::QuiltSampler(const IntegralCamera& camera, ViewGrid tiles, int width, int height,
                           std::uint64_t seed)
    : tiles_(tiles),
      directions_(directions_of(tiles, camera.optics.sheet())),
      eyes_{viewing_zone(camera.optics.sheet(), camera.optics.aperture()),
            camera.optics.aperture().distance},
      window_{camera.film.width * camera.film.pixel_pitch.x,
              camera.film.height * camera.film.pixel_pitch.y},
      width_(width),
      height_(height),
      tile_width_(width / tiles.columns),
      tile_height_(height / tiles.rows),
      left_over_(height - tile_height_ * tiles.rows),
      seed_(random_bits(0, seed))
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

std::optional<LensIndex> QuiltSampler::tile(int x, int y) const
{
    const int column = x / tile_width_, below = height_ - 1 - y, row = below / tile_height_;
    if (x < 0 || below < 0 || column >= tiles_.columns || row >= tiles_.rows)
        return std::nullopt;
    return LensIndex{column, row};
}

PixelOutcome QuiltSampler::outcome(int x, int y) const
{
    PixelOutcome outcome;
    outcome.film_points = 1;
    if (const auto own = tile(x, y)) {
        outcome.imaged = 1;
        outcome.lens = *own;
    } else
        outcome.outside_aperture = 1;
    return outcome;
}

std::optional<BeamRay> QuiltSampler::sample(int x, int y, bool same_pattern,
                                            std::uint32_t index) const
{
    const auto view = tile(x, y);
    if (!view)
        return std::nullopt;
    // The first samples of each square of pixels are points of one sequence.
    const auto across = std::uint32_t(x - view->i * tile_width_),
               up = std::uint32_t(height_ - 1 - y - view->j * tile_height_);
    std::uint64_t key = seed_;
    std::uint32_t place = 0;
    if (!same_pattern) {
        key = random_bits(key, std::uint64_t(view->j * tiles_.columns + view->i));
        key = random_bits(key, std::uint64_t(across / curve_side) << 32 | up / curve_side);
        place = place_on_curve(across % curve_side, up % curve_side);
    }
    const UnitPoint first = scrambled_point(point_seeds(random_bits(key, first_samples)), place);
    if (index == 0)
        return ray_within(x, y, first);
    return ray_within(x, y,
                      ShiftedPoints(point_seeds(random_bits(key, further_samples)), first)(index));
}

std::optional<BeamRay> QuiltSampler::reference(int x, int y, std::uint64_t set,
                                               std::uint32_t index) const
{
    const std::uint64_t pixel = random_bits(random_bits(seed_, std::uint64_t(x)), std::uint64_t(y)),
                        key = random_bits(random_bits(pixel, reference_samples), set);
    return ray_within(x, y, scrambled_point(point_seeds(key), index));
}

QuiltGeometry QuiltSampler::geometry() const
{
    const auto step = [&](int tiles) {
        const auto eye = [&](int view) { return eye_of_view(eyes_, directions_, view); };
        return directions_.count() > tiles ? eye(tiles) - eye(0) : Vec2{};
    };
    return {width_,
            height_,
            tile_width_,
            tile_height_,
            tiles_,
            {window_.x / tile_width_, window_.y / tile_height_},
            tiles_.columns > 1 ? step(1) : Vec2{},
            step(tiles_.columns),
            eyes_.distance};
}

} // namespace integral
