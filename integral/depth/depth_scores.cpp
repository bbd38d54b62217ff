// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/depth_scores.h"

#include "integral/base/number_text.h"
#include "integral/depth/texture.h"
#include "integral/optics/lens_mapping.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace integral {
namespace {

/// Whether any value within `reach` pixels differs by more than `step` from the pixel's value.
bool is_near_step(const std::vector<float>& values, int width, int height, int x, int y, int reach,
                  float step)
{
    const float own = values[std::size_t(y) * width + x];
    for (int j = std::max(0, y - reach); j <= std::min(height - 1, y + reach); ++j)
        for (int i = std::max(0, x - reach); i <= std::min(width - 1, x + reach); ++i)
            if (std::fabs(values[std::size_t(j) * width + i] - own) > step)
                return true;
    return false;
}

RegionScores scores_of(std::vector<float>& errors)
{
    RegionScores scores;
    scores.pixels = errors.size();
    if (errors.empty())
        return scores;
    const double share = 100.0 / double(errors.size());
    for (const float error : errors) {
        scores.mse += share * error * error;
        for (int k = 0; k < 3; ++k)
            scores.bad[k] += error > bad_limits[k] ? share : 0;
    }
    const auto quarter = errors.begin() + std::ptrdiff_t((errors.size() - 1) / 4);
    std::nth_element(errors.begin(), quarter, errors.end());
    scores.lower = 100 * *quarter;
    return scores;
}

/// The Frobenius norm of the Hessian matrix of value(x, y), by central differences of central
/// differences.
template <class Value> double bend_at(int x, int y, Value value)
{
    const double across = value(x + 2, y) - 2 * value(x, y) + value(x - 2, y),
                 down = value(x, y + 2) - 2 * value(x, y) + value(x, y - 2),
                 mixed = value(x + 1, y + 1) - value(x - 1, y + 1) - value(x + 1, y - 1) +
                         value(x - 1, y - 1);
    return 0.25 * std::sqrt(across * across + 2 * mixed * mixed + down * down);
}

} // namespace

std::vector<float> depths_seen(const ViewSet& views, const FrameMetadata& frame,
                               const DepthFrame& depths, Vec2 eye)
{
    const Film& film = frame.film;
    if (film.width != depths.metadata.film.width || film.height != depths.metadata.film.height)
        throw std::invalid_argument("it is of a frame of " +
                                    std::to_string(depths.metadata.film.width) + "x" +
                                    std::to_string(depths.metadata.film.height) + " pixels");
    const SheetOptics optics(frame.sheet, frame.aperture);
    std::vector<float> seen;
    for (int y = 0; y < views.height; ++y)
        for (int x = 0; x < views.width; ++x) {
            const Vec2 point = views.places.at(x, y);
            const Vec3 to_eye{eye.x - point.x, eye.y - point.y, -frame.aperture.distance};
            const Vec2 at = pixel_from_film(film, optics.film_point_seen(point, to_eye));
            const int i = int(std::floor(at.x)), j = int(std::floor(at.y));
            const bool inside = i >= 0 && j >= 0 && i < film.width && j < film.height;
            const std::size_t k = inside ? std::size_t(j) * film.width + i : 0;
            seen.push_back(inside && depths.imaged[k] > 0 ? depths.depth[k] : NAN);
        }
    return seen;
}

std::vector<float> true_disparities(const ViewSet& views, const FrameMetadata& frame,
                                    const DepthFrame& depths)
{
    std::vector<float> truth = depths_seen(views, frame, depths, {0, 0});
    for (float& value : truth)
        value = std::isfinite(value) ? float(views.scale->disparity(value)) : NAN;
    return truth;
}

std::vector<float> true_disparities(const ViewSet& views, const DepthFrame& quilt)
{
    const Film& film = quilt.metadata.film;
    const ViewGrid tiles = quilt.metadata.quilt->grid,
                   grid = directions_of(tiles, quilt.metadata.sheet);
    const int width = film.width / tiles.columns, height = film.height / tiles.rows;
    if (width != views.upright_width() || height != views.upright_height())
        throw std::invalid_argument("its views have " + size_text(width, height) +
                                    " pixels, and the input's " +
                                    size_text(views.upright_width(), views.upright_height()));
    if (!views.scale)
        throw std::invalid_argument(
            "it has depths in mm, and the eyes of the views are unknown; give --eyes");
    const EyeGrid& eyes = *quilt.metadata.quilt->eyes;
    const Vec2 eye = middle_eye(grid, {eyes.zone.x / grid.columns, eyes.zone.y / grid.rows});
    const double distance = views.scale->distance;
    if (length(eye - views.eye) > 1e-3 * distance ||
        std::fabs(eyes.distance - distance) > 1e-3 * distance)
        throw std::invalid_argument(
            "its middle view is of an eye in another place; give the depths of the same quilt");
    const int middle = grid.rows / 2 * grid.columns + grid.columns / 2,
              left = middle % tiles.columns * width,
              top = film.height - (middle / tiles.columns + 1) * height;
    std::vector<float> truth;
    truth.reserve(views.pixels());
    for (int y = 0; y < views.height; ++y)
        for (int x = 0; x < views.width; ++x) {
            const std::size_t at = views.upright_pixel(x, y), row = at / std::size_t(width),
                              column = at % std::size_t(width);
            const float mm = quilt.depth[(std::size_t(top) + row) * std::size_t(film.width) +
                                         std::size_t(left) + column];
            truth.push_back(std::isfinite(mm) ? float(views.scale->disparity(mm)) : NAN);
        }
    return truth;
}

DepthScores depth_scores(const ViewSet& views, const std::vector<float>& disparity,
                         const std::vector<float>& truth, int border)
{
    constexpr int edge_reach = 3;
    constexpr float edge_step = 0.1f;
    constexpr double least_texture = 0.02, flat = 5e-4, most_bumpy = 0.05;
    const Texture texture_of(views);
    std::vector<float> all, edges, planes, texture;
    double bumps = 0;
    std::size_t bends = 0;
    const auto true_at = [&](int x, int y) {
        return double(truth[std::size_t(y) * views.width + x]);
    };
    const auto error_at = [&](int x, int y) {
        return disparity[std::size_t(y) * views.width + x] - true_at(x, y);
    };
    for (int y = border; y < views.height - border; ++y)
        for (int x = border; x < views.width - border; ++x) {
            const std::size_t at = std::size_t(y) * views.width + x;
            const float error = std::fabs(disparity[at] - truth[at]);
            if (!std::isfinite(error))
                continue;
            all.push_back(error);
            if (is_near_step(truth, views.width, views.height, x, y, edge_reach, edge_step)) {
                edges.push_back(error);
                continue;
            }
            if (texture_of.at(x, y) > least_texture)
                texture.push_back(error);
            const bool inside = std::min(x, y) >= 2 && x < views.width - 2 && y < views.height - 2;
            if (!inside || !(bend_at(x, y, true_at) < flat))
                continue;
            planes.push_back(error);
            if (const double bend = bend_at(x, y, error_at); std::isfinite(bend)) {
                bumps += std::min(most_bumpy, bend);
                ++bends;
            }
        }
    const double bumpiness = bends > 0 ? 100 * bumps / double(bends) : 0;
    return {scores_of(all), scores_of(edges), scores_of(planes), bumpiness, scores_of(texture)};
}

} // namespace integral
