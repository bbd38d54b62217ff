// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/wireframe/lens_raster.h"

#include <algorithm>

namespace integral {
namespace {

Colour between(Colour a, Colour b, double t)
{
    const float u = float(t), v = 1 - u;
    return {v * a.r + u * b.r, v * a.g + u * b.g, v * a.b + u * b.b, 1};
}

/// Rounds a small number down to a whole one.
int whole_below(double value)
{
    const int towards_zero = int(value);
    return towards_zero - (value < towards_zero);
}

/// Narrows [first, last] to where least <= from + t * step <= most.
void clip(double from, double step, double least, double most, double& first, double& last)
{
    if (step == 0) {
        if (from < least || from > most)
            last = -1;
        return;
    }
    const double a = (least - from) / step, b = (most - from) / step;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
}

} // namespace

void LensRaster::begin(const LensRun* begin, const LensRun* end)
{
    box_ = {begin->first, begin->row, begin->end, (end - 1)->row + 1};
    std::vector<int>& left = left_;
    left.assign(std::size_t(rows()), INT32_MAX);
    columns_ = 0;
    for (const LensRun* run = begin; run != end; ++run) {
        int& first = left[std::size_t(run->row - box_.top)];
        first = std::min(first, run->first); // runs of a row are in order
        columns_ = std::max(columns_, run->end - first);
        box_.left = std::min(box_.left, run->first);
        box_.right = std::max(box_.right, run->end);
    }
    upright_ = box_.right - box_.left <= 2 * columns_;
    if (upright_)
        columns_ = box_.right - box_.left;
    for (int& first : left)
        if (upright_ || first == INT32_MAX)
            first = box_.left;
    empty_.assign(std::size_t(stride()) * std::size_t(rows() + 2) + 1, blocked);
    for (const LensRun* run = begin; run != end; ++run) {
        const int row = run->row - box_.top;
        const auto at = empty_.begin() +
                        std::ptrdiff_t(place(run->first - left[std::size_t(row)], row));
        std::fill(at, at + (run->end - run->first), nothing);
    }
    colour_.resize(empty_.size());
    clear();
}

void LensRaster::draw_point(const FilmCorner& at)
{
    if (!is_in_box(at.pixel))
        return;
    draw_at(index_at(int(at.pixel.x), int(at.pixel.y)), float(at.depth), at.colour);
}

void LensRaster::draw_line(const FilmCorner& from, const FilmCorner& to)
{
    const Vec2 way = to.pixel - from.pixel;
    double first = 0, last = 1;
    if (!is_in_box(from.pixel) || !is_in_box(to.pixel)) {
        const auto [left, right] = std::minmax(from.pixel.x, to.pixel.x);
        const auto [above, below] = std::minmax(from.pixel.y, to.pixel.y);
        if (right < box_.left || left > box_.right || below < box_.top || above > box_.bottom)
            return;
        clip(from.pixel.x, way.x, box_.left, box_.right, first, last);
        clip(from.pixel.y, way.y, box_.top, box_.bottom, first, last);
        if (!(first <= last))
            return;
    }
    const bool flat = std::fabs(way.x) >= std::fabs(way.y);
    const double start = flat ? from.pixel.x : from.pixel.y, step = flat ? way.x : way.y;
    const double a = start + first * step, b = start + last * step;
    const int least = whole_below(std::min(a, b)), most = whole_below(std::max(a, b));
    for (int k = least; k <= most; ++k) {
        const double t = step == 0 ? 0 : std::clamp((k + 0.5 - start) / step, first, last);
        const Vec2 at = from.pixel + t * way;
        const std::size_t index = index_at(flat ? k : whole_below(at.x),
                                           flat ? whole_below(at.y) : k);
        const float depth = float(from.depth + t * (to.depth - from.depth));
        if (is_seen_at(index, depth))
            draw_at(index, depth, between(from.colour, to.colour, t));
    }
}

void LensRaster::fill_row(int y, double depth, Colour colour)
{
    for_each_pixel_in({box_.left, y, box_.right, y + 1},
                      [&](std::size_t index, int, int) { draw_at(index, float(depth), colour); });
}

void LensRaster::fill(double depth, Colour colour)
{
    for (std::size_t k = 0; k < depth_.size(); ++k)
        draw_at(k, float(depth), colour);
}

} // namespace integral
