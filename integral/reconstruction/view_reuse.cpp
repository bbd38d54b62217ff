// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/reconstruction/view_reuse.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace integral {

namespace {

// A pixel uses samples of views whose eyes are at most most_views away, in steps between
// neighbouring eyes: in one direction, or in two. At a distance of r steps the weight is
// exp(-fall r^2). Tuned on POV-Ray's sample scenes: fewer views are better for highlights, which
// lie elsewhere for each eye, more views for textures and outlines.
constexpr double most_views = 8, most_views_in_two_directions = 2.9, fall = 0.03;

// Depths are a pixel's and its neighbours'. If the places of two successive depths in another view
// are at most this many pixels apart, the places in between are used, too: they are of one surface.
// The gap must be wide enough for the pixels around two places to be different ones.
constexpr double most_gap = 6;

// Places nearer to the eye than this fraction of its distance from the sheet are not found.
constexpr double nearest_to_eye = 0.05;

} // namespace

ViewReuse::ViewReuse(const QuiltGeometry& quilt) : quilt_(quilt)
{
    const bool two = quilt.by_column.y != quilt.by_row.y && quilt.by_column.x != quilt.by_row.x;
    const auto shortest = [&](double Vec2::*axis) {
        double least = 0;
        for (const double step : {std::fabs(quilt.by_column.*axis), std::fabs(quilt.by_row.*axis)})
            if (step > 0 && (least == 0 || step < least))
                least = step;
        return least;
    };
    const Vec2 next{shortest(&Vec2::x), shortest(&Vec2::y)};
    const double most = two ? most_views_in_two_directions : most_views;
    Vec2 furthest;
    for (int row = 1 - quilt.tiles.rows; row < quilt.tiles.rows; ++row)
        for (int column = 1 - quilt.tiles.columns; column < quilt.tiles.columns; ++column) {
            const Vec2 eye = double(column) * quilt.by_column + double(row) * quilt.by_row;
            const double distance = std::hypot(next.x > 0 ? eye.x / next.x : 0,
                                               next.y > 0 ? eye.y / next.y : 0);
            if (distance > 1.0001 * most || (column == 0 && row == 0))
                continue;
            Step step{column, row, {eye.x / quilt.pixel.x, -eye.y / quilt.pixel.y}, 0, {}};
            step.pixels = length(step.eye);
            most_pixels_ = std::max(most_pixels_, step.pixels);
            std::fill_n(step.part.values, 8, float(std::exp(-fall * distance * distance)));
            steps_.push_back(step);
            furthest = {std::max(furthest.x, std::fabs(eye.x)),
                        std::max(furthest.y, std::fabs(eye.y))};
            rows_ = std::max(rows_, (std::abs(row) + (eye.y != 0)) * quilt.tile_height);
        }
    const double next_eye = std::max(next.x, next.y);
    footprint_ = BeamFootprint::of_view(quilt.pixel, quilt.distance, furthest, next_eye);
    most_tilt_ = 100 * quilt.distance / std::max(next_eye, std::min(quilt.pixel.x, quilt.pixel.y));
}

/// Appends the pixels of the tile `step` away from `tile` in the given columns and rows of the
/// picture.
void ViewReuse::append(const Step& step, Span across, Span down, LensIndex tile,
                       ReuseNeighbourhood::Scratch& scratch) const
{
    const int column = int(tile.i) + step.columns, row = int(tile.j) + step.rows,
              left = column * quilt_.tile_width,
              bottom = quilt_.height - 1 - row * quilt_.tile_height;
    across.first = std::max(across.first, left);
    across.last = std::min(across.last, left + quilt_.tile_width - 1);
    down.first = std::max(down.first, bottom - quilt_.tile_height + 1);
    down.last = std::min(down.last, bottom);
    for (int y = down.first; y <= down.last; ++y)
        for (int x = across.first; x <= across.last; x += 8) {
            if (scratch.found.size() <= scratch.number)
                scratch.found.resize(2 * scratch.number + 64);
            scratch.found[scratch.number++] = {std::ptrdiff_t(y) * quilt_.width + x,
                                               0xffu >> std::max(0, x + 7 - across.last),
                                               LightFieldImage::stored({column, row}), &step.part};
        }
}

/// The pixels whose samples may lie on a pixel's footprint: less than one pixel away from the
/// places `from` to `to` of its image in another view, in either order.
ViewReuse::Span ViewReuse::pixels_around(double from, double to)
{
    const double first = std::min(from, to), last = std::max(from, to);
    constexpr double far = 1e9; // outside every picture
    const int low = int(std::clamp(first, -far, far)),
              high = int(std::clamp(last, -far, far)); // towards 0
    return {low - (first < low), high + (last > high)};
}

/// Appends the pixels of one other view that show the pixel at one of the `parts`, which are in
/// increasing order: of the way between the two eyes, the part by which places at a depth move.
void ViewReuse::find_in(const Step& step, double left, double top, LensIndex tile,
                        const std::vector<double>& parts,
                        ReuseNeighbourhood::Scratch& scratch) const
{
    std::size_t begin = 0;
    for (std::size_t k = 1; k <= parts.size(); ++k) {
        const bool is_gap = k < parts.size() && (parts[k] - parts[k - 1]) * step.pixels > most_gap;
        if (k < parts.size() && !is_gap)
            continue;
        const double from = parts[begin], to = parts[k - 1];
        append(step, pixels_around(left + from * step.eye.x, left + to * step.eye.x),
               pixels_around(top + from * step.eye.y, top + to * step.eye.y), tile, scratch);
        begin = k;
    }
}

void ViewReuse::find(int x, int y, LensIndex tile, const std::vector<float>& depths,
                     ReuseNeighbourhood::Scratch& scratch) const
{
    scratch.number = 0;
    std::vector<double>& parts = scratch.parts;
    parts.clear();
    for (const float depth : depths) {
        const double z = std::max<double>(depth, (nearest_to_eye - 1) * quilt_.distance);
        parts.push_back(z / (z + quilt_.distance));
    }
    // The ends are enough of depths that are near each other even in the furthest view.
    if (parts.size() > 2 && (parts.back() - parts.front()) * most_pixels_ <= most_gap) {
        parts[1] = parts.back();
        parts.resize(2);
    }
    for (const Step& step : steps_) {
        const auto column = tile.i + step.columns, row = tile.j + step.rows;
        if (column >= 0 && column < quilt_.tiles.columns && row >= 0 && row < quilt_.tiles.rows)
            find_in(step, x + step.columns * quilt_.tile_width, y - step.rows * quilt_.tile_height,
                    tile, parts, scratch);
    }
}

} // namespace integral
